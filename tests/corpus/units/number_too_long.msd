import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(0.26000000000000000000000000000000000000000000000001 m/s) //~ error LM0304
        1: after 1e60 s   -> again //~ error LM0304
        2: contact_force > 300 N^200/N^199 -> again //~ error LM0304
    }
}
