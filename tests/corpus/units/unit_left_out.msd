import std.robots.j5

behavior wander on j5 {
    flag pressed = contact_force > 115 //~ error LM0303
    flag stuck   = held(pressed, 200) //~ error LM0303

    entry go

    mode go {
        drive(0.26) //~ error LM0303
        1: stuck   -> turn_away
        2: after 5 -> turn_away //~ error LM0303
    }
    mode turn_away {
        turn(random(-120, 120 deg)) //~ error LM0303
        1: done -> go
    }
}

world hallway {
    wall (0, 0 m) -> (12 m, 0 m) //~ error LM0303
    box mass 30 size (0.4 m, 0.6 m) at (3 m, 1 m) //~ error LM0303
}

scenario short_drive runs wander {
    duration 10 //~ error LM0303
    place robot at (0 m, 0 m) heading 90 //~ error LM0303
    place box mass 30 kg size (0.4 m, 0.6 m) at 1 ahead //~ error LM0303
    expect never stuck before 5 //~ error LM0303
    expect go -> turn_away within 1 s .. 2 //~ error LM0303
}
