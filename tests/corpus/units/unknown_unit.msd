import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(0.6 mph) //~ error LM0302
        1: after 5 sec -> turn_away //~ error LM0302
    }
    mode turn_away {
        turn(90 degrees) //~ error LM0302
        1: done       -> go
        2: after 5 S  -> go //~ error LM0302
        3: after 5 mS -> go //~ error LM0302
    }
}

robot rover {
    body differential_drive { mass 20 Kg  size (0.5 meter, 0.4 m)  track 350 MM  traction 0.6 } //~ error LM0302, error LM0302, error LM0302
    sensor angle: degree in -180 .. 180  fails 0 //~ error LM0302
    sensor speed: cm/sec in -100 .. 100  fails 0  = wheel.left.speed //~ error LM0302
    action halt() = body.stop()
}
