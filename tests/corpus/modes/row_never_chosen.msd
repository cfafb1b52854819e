import std.networks.obstacle_id

robot nudger {
    sensor left: m/s^2 in -4 .. 4 fails 0
    sensor right: m/s^2 in -4 .. 4 fails 0
    sensor force: N in 0 .. 100 fails 0
    action halt()
    action drive(speed: m/s)
}

behavior shy on nudger {
    sense obstacle_id(left, right, force)

    entry go

    mode go {
        decide (force, left) {
            (low,  _  ) => drive(26 cm/s)
            (med,  _  ) => drive(10 cm/s)
            (high, neg) => halt() //~ warning LM0425
        }
        1: force is high -> stop //~ warning LM0409
        2: after 60 s    -> stop
    }
    mode stop {
        halt()
        1: after 1 s -> go
    }
}
