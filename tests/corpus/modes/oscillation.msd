import std.robots.j5

behavior nudge on j5 {
    entry push

    mode push {
        drive(26 cm/s)
        1: contact_force > 115 N and after 2 s -> back_up //~ info LM0421
    }
    mode back_up {
        drive(-20 cm/s)
        1: contact_force > 20 N and after 1 s -> push
    }
}
