import std.robots.j5

behavior careful on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 20 N or contact_force < 150 N -> stop //~ warning LM0410
        2: after 10 s -> back_up
    }
    mode stop {
        halt()
        1: after 1 s -> back_up
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> forward
    }
}
