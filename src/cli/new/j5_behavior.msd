import std.networks.obstacle_id
import std.robots.j5

/// Drives ahead, and turns away from whatever it hits.
behavior NAME on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry wait

    /// The sensors settle.
    mode wait {
        halt()
        1: after 2 s -> forward
    }
    mode forward {
        drive(26 cm/s)
        1: forward_collision -> back_up
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> turn_away
    }
    mode turn_away {
        turn(random(60 deg, 120 deg))
        1: done -> forward
    }
}

/// Whatever it hits, it lets go of within two seconds.
property lets_go: back_up leads to not back_up within 2 s
