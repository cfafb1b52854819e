import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: contact_force > 20 N -> rest
    }
    mode rest {
        halt()
        1: after 5 ms -> go //~ warning LM0314
    }
}

scenario short_drive runs wander {
    duration 5 s   tick 20 ms
    expect modes go, rest
}
