import std.networks.obstacle_id
import std.networks.preliminary_obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)
    sense preliminary_obstacle_id(left_wheel_acceleration, right_wheel_acceleration)

    entry go

    mode go {
        drive(26 cm/s)
        1: forward_collision             -> again //~ error LM0206
        2: obstacle_id.forward_collision -> again
        3: heavy_obstacle                -> again
    }
}
