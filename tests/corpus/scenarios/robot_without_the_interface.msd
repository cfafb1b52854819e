import std.interfaces.mobile_base

robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    action halt() = body.stop()
}

behavior wait on mobile_base {
    entry look

    mode look {
        halt()
        1: after 2 s -> again
    }
}

scenario short_wait runs wait on rover { //~ error LM0204
    duration 3 s
}

scenario nowhere runs wait { //~ error LM0311
    duration 3 s
}
