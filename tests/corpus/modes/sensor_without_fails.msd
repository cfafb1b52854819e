robot cart {
    sensor front: m in 0 .. 5 //~ warning LM0606
    sensor rear:  m in 0 .. 5 fails 5
    // Nothing depends on it.
    sensor side:  m in 0 .. 5
    action halt()
    action drive(speed: m/s)
}

behavior shuttle on cart {
    entry ahead

    mode ahead {
        drive(0.3 m/s)
        1: front < 0.5 m -> back
    }
    mode back {
        drive(-0.3 m/s)
        1: after 1 s and rear < 0.5 m -> ahead
    }
}
