import std.robots.j5

behavior undecided on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 115 N -> back_up
        2: contact_force > 115 N -> stop //~ warning LM0412
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> stop
    }
    mode stop {
        halt()
        1: after 1 s -> forward
    }
}
