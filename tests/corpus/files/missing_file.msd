// Neither the network nor its event is reported as unknown too.
import obstacle_idd //~ error LM0003
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        drive(26 cm/s)
        1: forward_collision -> again
    }
}
