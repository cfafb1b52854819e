import std.robots.j5

behavior push_ahead on j5 {
    entry push

    mode push requires contact_force else rest { //~ error LM0405
        arc(26 cm/s, radius: 1 m)
        1: after 4 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> push
    }
}
