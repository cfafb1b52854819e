import std.robots.j5

behavior wander on j5 {
    flag bumped = contact_force > 115 N

    entry go

    mode go {
        drive(26 cm/s)
        0: after 5 s             -> turn_away //~ error LM0309
        1.5: after 6 s           -> turn_away //~ error LM0309
        2: count(bumped) >= 1.5  -> turn_away //~ error LM0309
        3: count(bumped) > -1    -> turn_away //~ error LM0309
        4: after -2 s            -> turn_away //~ error LM0309
        5: after 0.3 ns          -> turn_away //~ error LM0309
    }
    mode turn_away {
        turn(90 deg + 5 deg) //~ error LM0309
        1: done -> go
    }
}

robot rover {
    body differential_drive { mass 0 kg  size (0.5 m, -0.4 m)  track 0.35 m  traction 0.6 } //~ error LM0309, error LM0309
    sensor force: N in 0 .. 400  fails set  = wedge.force  noise -2 //~ error LM0309, error LM0309
    action halt() -> done = body.stop() //~ error LM0309
}

scenario short_drive runs wander {
    duration -10 s //~ error LM0309
    tick 0 ms //~ error LM0309
    place robot at 1 m ahead //~ error LM0309
    place box mass -30 kg size (0.4 m, 0.6 m) at -1 m ahead //~ error LM0309, error LM0309
    fault contact_force = absent //~ error LM0309
    expect never bumped before 0 s //~ error LM0309
}
