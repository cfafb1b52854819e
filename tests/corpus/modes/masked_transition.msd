import std.networks.obstacle_id
import std.robots.j5

behavior heavy_last on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry forward

    mode forward {
        drive(26 cm/s)
        1: forward_collision -> back_up
        2: heavy_obstacle    -> stop //~ warning LM0402
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> stop
    }
    mode stop {
        halt()
        1: after 1 s -> forward
    }
}
