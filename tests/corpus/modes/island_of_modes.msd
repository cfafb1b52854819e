import std.robots.j5

behavior wander on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: after 5 s -> stop
    }
    mode stop {
        halt()
        1: after 1 s -> forward
    }
    mode back_up { //~ warning LM0417
        drive(-20 cm/s)
        1: after 1 s -> turn_away
    }
    mode turn_away {
        turn(90 deg)
        1: done -> back_up
        2: after 5 s -> forward
    }
}
