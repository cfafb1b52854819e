import std.robots.j5

behavior wander on j5 extends wander { //~ error LM0205
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}
