import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> parked
    }
    final mode parked { halt() }
    mode rest { //~ warning LM0404
        halt()
        1: after 1 s -> go
    }
    mode back_up { //~ warning LM0404
        drive(-20 cm/s)
        1: after 1 s -> go
    }
}
