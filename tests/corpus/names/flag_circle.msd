import std.robots.j5

behavior wander on j5 {
    flag calm    = not pressed and not alarmed //~ error LM0205
    flag pressed = contact_force > 100 N and not calm
    flag alarmed = held(pressed, 200 ms)
    flag loop    = loop or contact_force > 300 N //~ error LM0205

    entry go

    mode go {
        drive(26 cm/s)
        1: alarmed -> again
        2: loop    -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect never alarmed
}
