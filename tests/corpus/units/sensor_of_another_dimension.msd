import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(contact_force, right_wheel_acceleration, left_wheel_acceleration) //~ error LM0301, error LM0301

    entry go

    mode go {
        drive(26 cm/s)
        1: forward_collision -> again
    }
}
