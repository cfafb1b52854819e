import std.robots.j5

behavior patient on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: after 10 s -> back_up //~ warning LM0413
        2: after 5 s  -> stop
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> stop
    }
    mode stop {
        halt()
        1: contact_force > 115 N -> back_up
        2: after 1 s -> forward
    }
}
