import std.robots.j5

behavior wander on j5 {
    entry //~ error LM0101
    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}
