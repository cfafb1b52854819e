// `heavy_obstacle` is an event of `obstacle_id`, which is imported but not sensed.
import std.networks.obstacle_id
import std.networks.preliminary_obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense preliminary_obstacle_id(left_wheel_acceleration, right_wheel_acceleration)

    entry go

    mode go {
        drive(26 cm/s)
        1: heavy_obstacle    -> again //~ error LM0201
        2: forward_collision -> again
    }
}
