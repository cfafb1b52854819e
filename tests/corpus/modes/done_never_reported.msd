import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: done -> turn_away //~ error LM0313
    }
    mode turn_away {
        on enter { turn(90 deg) }
        1: done or after 9 s -> go //~ error LM0313
    }
}
