import std.robots.j5

interface base {
    action halt()
    action halt() //~ error LM0202
    action drive(speed: m/s, speed: m/s) //~ error LM0202
}

interface base { //~ error LM0202
    action stop()
}

robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor force: N in 0 .. 400  fails 0  = wedge.force
    sensor force: N in 0 .. 500  fails 0  = wedge.force //~ error LM0202
    action halt() = body.stop()
    action halt() = body.velocity(0 m/s, 0 deg/s) //~ error LM0202
}

behavior wander on j5 {
    flag pressed = contact_force > 115 N
    flag pressed = contact_force > 150 N //~ error LM0202

    entry go

    mode go {
        drive(26 cm/s)
        1: pressed -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
    mode rest { //~ error LM0202
        halt()
        1: after 2 s -> go
    }
}

behavior wander on j5 { //~ error LM0202
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
    place box crate mass 30 kg size (0.4 m, 0.6 m) at 1 m ahead
    place box crate mass 40 kg size (0.4 m, 0.6 m) at 2 m ahead //~ error LM0202
}

world hallway {
    box crate mass 30 kg size (0.4 m, 0.6 m) at (2 m, 0 m)
    box crate mass 40 kg size (0.4 m, 0.6 m) at (4 m, 0 m) //~ error LM0202
}
