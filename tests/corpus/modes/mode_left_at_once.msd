import std.robots.j5

behavior careful on j5 {
    entry forward

    mode forward { //~ warning LM0411
        drive(26 cm/s)
        1: contact_force >= 115 N -> back_up
        2: contact_force < 115 N  -> stop
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> forward
    }
    mode stop {
        halt()
        1: after 1 s -> forward
    }
}
