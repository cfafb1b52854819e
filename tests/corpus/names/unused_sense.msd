import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force) //~ warning LM0209

    entry go

    mode go {
        drive(26 cm/s)
        1: contact_force > 20 N -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
