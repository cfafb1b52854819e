import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> bakc_up //~ error LM0201
    }
    mode back_up requires contact_force else rset { //~ error LM0201
        drive(-20 cm/s)
        1: after 1 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
