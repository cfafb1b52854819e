import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    flag pressed = contact_force //~ error LM0306

    entry go

    mode go {
        drive(26 cm/s)
        1: pressed and not left_wheel_acceleration -> again //~ error LM0306
        2: count(pressed)                          -> again //~ error LM0306
        3: 5 s                                     -> again //~ error LM0306
        4: rising(contact_force)                   -> again //~ error LM0306
    }
}
