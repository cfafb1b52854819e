import lookout

robot cart {
    sensor left:  m in 0 .. 5 fails 5
    sensor right: m in 0 .. 5 fails 0, 5
    action halt()
    action drive(speed: m/s)
}

behavior careful on cart {
    sense lookout(left, right)

    entry ahead

    mode ahead {
        drive(0.3 m/s)
        1: blocked     -> stop //~ warning LM0602
        2: tight       -> slow //~ warning LM0603
        3: after 1 min -> stop
    }
    mode slow {
        drive(0.1 m/s)
        1: not tight   -> ahead
        2: after 1 min -> stop
    }
    mode stop {
        halt()
        1: not blocked                   -> ahead
        2: failed(left) or failed(right) -> stuck
    }
    final mode stuck {
        halt()
    }
}
