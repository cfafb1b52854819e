import std.robots.j5

behavior wander on j5 {
    flag pressed = contact_force > 115 N
    flag edge    = raising(pressed) //~ error LM0201
    flag often   = counter(pressed) > 2 //~ error LM0201

    entry go

    mode go {
        drive(26 cm/s)
        1: edge or often -> again
    }
}
