import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s) //~ warning LM0422
        turn(90 deg)
        1: done -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
