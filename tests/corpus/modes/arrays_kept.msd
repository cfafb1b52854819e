// Arrays and contacts that interfaces promise, and what keeps them.
interface seeing {
    sensor range[3]: m in 0 .. 10
    sensor nearest: m in 0 .. 10
    sensor touched: contact
    logical group = min(range) //~ error LM0309
    action halt()
}

robot keeps provides seeing {
    sensor range[4]: m in 0 .. 8 fails 8
    sensor bumper[2]: contact fails set
    logical nearest = min(range)
    logical touched = any(bumper)
    action halt()
}

robot too_few provides seeing { //~ error LM0312
    sensor range[2]: m in 0 .. 8 fails 8
    logical nearest = min(range)
    sensor touched: contact fails set
    action halt()
}

robot others provides seeing { //~ error LM0312
    sensor range: m in 0 .. 8 fails 8
    sensor beams[2]: m in 0 .. 12 fails 8
    logical nearest = min(beams) //~ error LM0312
    sensor touched: 1 in 0 .. 1 fails 0 //~ error LM0312
    action halt()
}

robot broken provides seeing {
    sensor range[3]: parsec in 0 .. 8 //~ error LM0302
    logical nearest = min(range)
    sensor touched: contact fails set
    action halt()
}

behavior careful on seeing {
    entry go

    mode go {
        halt()
        1: touched or nearest < 1 m or range[1] < 0.5 m or group < 1 m -> stop
        2: failed(touched) or failed(range)                            -> stop
    }
    mode stop {
        halt()
        1: not touched -> go
    }
}
