import std.networks.obstacle_id
import std.networks.preliminary_obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, force: contact_force)
    sense mirrored = preliminary_obstacle_id(right: left_wheel_acceleration, left: right_wheel_acceleration)

    flag hit = obstacle_id.forward_collision or mirrored.forward_collision

    entry go

    mode go {
        drive(26 cm/s)
        1: heavy_obstacle -> again
        2: hit            -> again
    }
}
