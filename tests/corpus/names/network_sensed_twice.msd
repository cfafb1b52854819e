import std.networks.preliminary_obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense preliminary_obstacle_id(left_wheel_acceleration, right_wheel_acceleration)
    sense preliminary_obstacle_id(right_wheel_acceleration, left_wheel_acceleration) //~ error LM0202

    entry go

    mode go {
        drive(26 cm/s)
        1: forward_collision -> again
    }
}
