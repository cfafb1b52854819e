/// A robot that is measured, not built.
robot sled {
    sensor force: N in 0 .. 400 fails 0
    action halt()
    action drive(speed: m/s)
    action arc(speed: m/s, radius: m)
    action turn(angle: deg) -> done
}

/// The modes of the manipulation experiment, switched by comparisons in place of a network.
behavior switching on sled {
    flag hit   = force > 60 N
    flag heavy = force > 150 N

    entry init

    mode init {
        halt()
        1: after 2 s -> forward
    }
    mode forward {
        drive(26 cm/s)
        1: heavy -> stop
        2: hit   -> push
    }
    mode stop {
        halt()
        1: after 500 ms -> back_up
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> turn_away
    }
    mode turn_away {
        turn(120 deg)
        1: done -> forward
    }
    mode push requires force else stop {
        arc(26 cm/s, radius: 1 m)
        1: heavy     -> stop
        2: after 4 s -> forward
    }
}
