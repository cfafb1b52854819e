import std.networks.obstacle_id
import std.robots.j5

behavior shy on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        decide (force, left, heavy_obstacle) {
            (low,         _,   clear) => drive(26 cm/s)
            ({med, high}, _,   clear) => drive(10 cm/s)
            (_,           _,   set  ) => halt()
            (high,        neg, _    ) => nothing //~ error LM0424
            (-,           -,   -    ) => halt() //~ error LM0424
        }
        1: after 60 s -> again
    }
}
