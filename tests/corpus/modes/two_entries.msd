import std.robots.j5

behavior wander on j5 {
    entry go
    entry rest //~ error LM0310

    mode go {
        drive(26 cm/s)
        1: after 5 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
