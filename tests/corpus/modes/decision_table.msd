// Readings, elements, groups, flags, events, contacts, failures and `is` as columns.
import std.networks.obstacle_id

robot pusher {
    sensor left: m/s^2 in -4 .. 4 fails 0
    sensor right: m/s^2 in -4 .. 4 fails 0
    sensor strain[3]: N in 0 .. 400 fails 0
    sensor bumper[2]: contact fails set
    logical strongest = max(strain)
    logical touched = any(bumper)
    action halt()
    action drive(speed: m/s)
    action turn(angle: deg) -> done
}

behavior reactive on pusher {
    sense obstacle_id(left, right, strongest)

    flag late = after 5 s

    entry go

    mode go {
        decide (force, touched, failed(strain[0, 2])) {
            (low,         clear, _    ) => drive(26 cm/s)
            ({med, high}, clear, set  ) => nothing
            ({med, high}, clear, clear) => either(turn(90 deg), turn(-90 deg), halt())
            (_,           set,   -    ) => drive(random(-20 cm/s, -10 cm/s))
        }
        1: done                                   -> wait
        2: strongest is any of {med, high}        -> look
        3: after 20 s                             -> again
    }
    mode wait {
        decide (heavy_obstacle, late, bumper[1], obstacle_id.left is pos) {
            (set,   _,     _, _    ) => halt()
            (clear, set,   _, clear) => drive(10 cm/s)
            (clear, set,   _, set  ) => drive(-10 cm/s)
            (clear, clear, _, _    ) => nothing
        }
        1: forward_collision or all_clear -> go
    }
    mode look {
        halt()
        1: after 1 s -> go
    }

    flag all_clear = left is zero and strongest is low and not touched
}

behavior calmer on pusher extends reactive {
    mode wait {
        decide (failed(touched)) {
            (set)   => halt()
            (clear) => drive(5 cm/s)
        }
        1: after 3 s -> go
    }
}
