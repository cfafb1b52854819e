variable contact: N in 0 .. 400 { //~ error LM0104
    low  = ramp(80, 20)
    high = ramp(20, 80)
}

network bump(force: contact) { //~ error LM0104
    event bumped {
        contributor (high)
        detractor   (low)
    }
}
