import std.robots.j5

behavior search on j5 {
    entry turn_about

    mode turn_about {
        turn(random(-120 deg, 120 deg))
        1: contact_force > 20 N -> rest
        2: after 2 s            -> again
        3: after 10 s           -> rest //~ warning LM0420
    }
    mode rest {
        halt()
        1: after 1 s -> turn_about
    }
}
