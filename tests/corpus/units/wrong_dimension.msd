import std.robots.j5

behavior wander on j5 {
    flag late = contact_force > 2 s //~ error LM0301

    entry go

    mode go {
        drive(26 cm) //~ error LM0301
        1: late        -> turn_away
        2: after 30 cm -> turn_away //~ error LM0301
        3: contact_force > left_wheel_acceleration -> turn_away //~ error LM0301
    }
    mode turn_away {
        turn(90 deg/s) //~ error LM0301
        1: done                   -> circle
        2: held(late, 20 percent) -> circle //~ error LM0302
    }
    mode circle {
        arc(26 cm/s, radius: 90 deg) //~ error LM0301
        1: after 5 s -> go
    }
}

scenario short_drive runs wander {
    duration 10 m //~ error LM0301
    tick 100 Hz //~ error LM0301
    place box mass 30 N size (0.4 m, 0.6 m) at 1 m ahead //~ error LM0301
    fault contact_force = 3 m/s^2 from 0 s //~ error LM0301
}
