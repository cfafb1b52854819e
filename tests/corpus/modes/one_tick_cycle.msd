import std.robots.j5

behavior nervous on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 115 N -> back_up //~ warning LM0416
    }
    mode back_up {
        drive(-20 cm/s)
        1: contact_force > 20 N -> forward
        2: after 1.5 s -> forward
    }
}
