// Failures that come and go, with and without readings of other sensors.

robot cart {
    sensor x: m in 0 .. 10 fails 0
    sensor y: m in 0 .. 10 fails 0
    action halt()
    action go(speed: m/s)
}

behavior at_other_readings on cart {
    entry ahead

    mode ahead {
        go(1 m/s)
        1: failed(x) and y < 5 m -> creep
        2: x < 1 m and not failed(x) -> rest
    }
    mode creep {
        go(0.1 m/s)
        1: y > 3 m and not failed(x) -> ahead //~ info LM0608
        2: y < 1 m -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> ahead
    }
}

// What requires a sensor is left for `else`, and entered again once the sensor has recovered.
behavior by_what_is_required on cart {
    entry rest

    mode rest {
        halt()
        1: y > 5 m -> approach //~ info LM0608
        2: after 60 s -> search
    }
    mode approach requires x else rest {
        go(1 m/s)
        1: x < 1 m -> search
        2: after 10 s -> rest
    }
    mode search {
        go(0.1 m/s)
        1: after 5 s -> rest
    }
}

// Never both at the same readings, and never at once.
behavior steady on cart {
    entry ahead

    mode ahead {
        go(1 m/s)
        1: failed(x) and y < 5 m -> creep
    }
    mode creep {
        go(0.1 m/s)
        1: y > 6 m and not failed(x) -> ahead
        2: after 1 s and not failed(x) -> ahead
    }
}
