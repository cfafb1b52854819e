import std.robots.j5

behavior careful on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 20 N  -> stop
        2: contact_force > 150 N -> back_up //~ warning LM0402
    }
    mode stop {
        halt()
        1: after 1 s -> forward
    }
    mode back_up { //~ warning LM0414
        drive(-20 cm/s)
        1: after 1.5 s -> stop
    }
}
