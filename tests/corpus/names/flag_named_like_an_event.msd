import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    flag heavy_obstacle = contact_force > 200 N //~ error LM0206
    flag contact_force  = forward_collision

    entry go

    mode go {
        drive(26 cm/s)
        1: heavy_obstacle -> again //~ error LM0206
        2: contact_force  -> again //~ error LM0206
    }
}
