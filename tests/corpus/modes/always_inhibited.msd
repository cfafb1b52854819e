import std.robots.j5

behavior careful on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: failed(contact_force) -> push //~ warning LM0418
        2: after 10 s -> push
    }
    mode push requires contact_force else forward {
        arc(26 cm/s, radius: 1 m)
        1: after 4 s -> forward
    }
}
