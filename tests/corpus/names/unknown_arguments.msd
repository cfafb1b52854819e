import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left: left_wheel_acceleration, right: right_wheel_acceleration, contact: contact_force) //~ error LM0201

    entry go

    mode go {
        arc(26 cm/s, radios: 1 m) //~ error LM0201
        1: forward_collision -> again
    }
}
