import std.robots.j5

behavior wander on j5 {
    flag pressed = contact_force > 20 N //~ warning LM0208
    flag stuck   = contact_force > 200 N

    entry go

    mode go {
        drive(26 cm/s)
        1: stuck -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
