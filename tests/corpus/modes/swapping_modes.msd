import std.robots.j5

behavior keep_pushing on j5 {
    flag heavy = contact_force > 150 N

    entry ahead

    mode ahead {
        drive(26 cm/s)
        1: heavy -> rest
    }
    mode rest {
        halt()
        1: not heavy -> ahead //~ warning LM0419
    }
}
