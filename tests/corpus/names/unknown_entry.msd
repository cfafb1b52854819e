import std.robots.j5

behavior wander on j5 {
    entry strat //~ error LM0201

    mode start {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}
