import std.robots.j5

behavior wander on j5 {
    flag bumped = contact_force > 115 N

    entry go

    mode go {
        drive(26 cm/s)
        1: bumped       -> rest
        2: after 5 s    -> rest
        1: after 10 s   -> rest //~ error LM0403
        2: after 20 s   -> rest //~ error LM0403
        2: after 30 s   -> rest //~ error LM0403
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
