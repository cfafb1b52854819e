import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        drive(26 cm/s)
        1: heavy_obstacle == 1      -> again //~ error LM0301
        2: forward_collision > 0.5  -> again //~ error LM0301
    }
}
