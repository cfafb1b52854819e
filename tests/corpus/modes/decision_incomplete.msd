import std.networks.obstacle_id
import std.robots.j5

behavior shy on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        decide (force, heavy_obstacle) { //~ error LM0423
            (low,         _    ) => drive(26 cm/s)
            (med,         clear) => drive(10 cm/s)
            ({med, high}, set  ) => halt()
        }
        1: after 60 s -> wait
    }
    mode wait {
        decide (failed(contact_force), force, left) { //~ error LM0423
            (set, _, _) => halt()
        }
        1: after 60 s -> go
    }
}
