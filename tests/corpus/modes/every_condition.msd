import std.networks.obstacle_id
import std.robots.j5

behavior careful on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    flag stuck   = pressed and not failed(contact_force)
    /// Flags may stand in any order.
    flag pressed = contact_force > 115 N

    entry forward

    mode forward {
        drive(26 cm/s)
        1: held(stuck or heavy_obstacle, 300 ms)            -> back_up
        2: rising(contact_force >= 20 N) and not pressed    -> push
        3: falling(pressed) or latched(stuck)               -> push
        4: count(rising(pressed) or heavy_obstacle) == 3    -> again
    }
    mode push requires contact_force, left_wheel_acceleration else back_up {
        arc(26 cm/s, radius: -1 m)
        1: (heavy_obstacle or 200 N < contact_force) and after 1 s -> back_up
        2: left_wheel_acceleration != right_wheel_acceleration     -> forward
        on exit { drive(0 m/s) }
    }
    mode back_up {
        on enter { drive(-20 cm/s) }
        1: after 1.5 s -> turn_away
    }
    mode turn_away {
        turn(random(-120 deg, 120 deg))
        1: done and not obstacle_id.forward_collision -> forward
        2: contact_force <= 10 N and after 8 s        -> parked
    }
    final mode parked {
        halt()
    }
}
