import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        arc(26 cm/s, speed: 30 cm/s) //~ error LM0310
        1: after 5 s -> again
    }
}
