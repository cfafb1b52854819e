import std.robots.j5

behavior careful on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 150 N and contact_force < 115 N -> back_up //~ warning LM0409
        2: after 10 s -> back_up
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> forward
    }
}
