import clearance

/// A small robot with two range finders and a battery.
robot rover {
    /// Ahead on the left.
    sensor left_range: m in 0 .. 4
    /// Ahead on the right.
    sensor right_range: m in 0 .. 4
    optional sensor battery: V in 0 .. 16 fails 16

    /// Stands still.
    action halt()
    /// Drives straight ahead.
    action drive(speed: m/s)
    /// Turns in place, to the left for a positive angle.
    action turn(angle: deg) -> done
}

/// Drives ahead, turns away from what blocks the way, and stops when the battery is low.
behavior patrol on rover {
    sense clearance(left_range, right_range)
    flag low = held(battery < 11 V, 1 s)

    entry wait

    /// Lets the range finders settle.
    mode wait {
        halt()
        1: after 500 ms -> cruise
    }
    mode cruise {
        drive(30 cm/s)
        1: low     -> parked
        2: blocked -> turn_away
    }
    mode turn_away {
        turn(random(60 deg, 120 deg))
        1: low  -> parked
        2: done -> cruise
    }
    final mode parked {
        halt()
    }
}
