import std.robots.j5

robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor force: N in 400 .. 0  fails 0  = wedge.force //~ error LM0308
    action halt() = body.stop()
}

behavior push on rover {
    flag pressed = force > 10 N

    entry go

    mode go requires force else rest {
        halt()
        1: pressed -> again
    }
    final mode rest { halt() }
}

behavior wander on j5 {
    entry go

    mode go {
        turn(random(120 deg, -120 deg)) //~ error LM0308
        1: done -> again
    }
}

scenario short_drive runs wander {
    duration 10 s
    fault contact_force = 0 N from 5 s to 2 s //~ error LM0308
    expect modes go, go
    expect go -> go within 8 s .. 4 s //~ error LM0308
}
