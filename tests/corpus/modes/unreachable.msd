import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
    mode rest { //~ warning LM0404
        halt()
        1: after 1 s -> back_up
    }
    mode back_up { //~ warning LM0404
        drive(-20 cm/s)
        1: after 1 s -> rest
    }
}
