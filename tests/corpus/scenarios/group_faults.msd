// Faults of arrays, elements, groups and contacts.
robot ring {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor speed[2]: m/s in -1 .. 1 fails 0 = wheel.left.speed
    sensor bumper: contact fails clear = bumper.front
    sensor force: N in 0 .. 100 fails 0 = bumper.front //~ error LM0309
    sensor back: contact fails clear = wedge.force //~ error LM0309
    logical mean_speed = mean(speed)
    action halt() = body.stop()
    action go() = body.travel(1 m, 0.2 m/s)
    action advance() -> done = body.travel(1 m, 0.2 m/s)
}

behavior idle on ring {
    entry go

    mode go {
        halt()
        1: mean_speed > 0.5 m/s or bumper -> go_on
    }
    mode go_on {
        advance()
        1: done -> go
    }
}

scenario several runs idle on ring {
    duration 1 s
    fault speed = 0.5 m/s from 0 s
    fault speed[1] = any from 0.1 s to 0.2 s
    fail mean_speed from 0.5 s
    fault bumper = set from 0.2 s
    fail bumper from 0.3 s
    expect never mean_speed > 0.9 m/s
    expect never bumper before 0.1 s
}

scenario wrong runs idle on ring {
    duration 1 s
    fault speed = set from 0 s //~ error LM0309
    fault speed[2] = 0 m/s from 0 s //~ error LM0201
    fault bumper = 1 from 0 s //~ error LM0309
    fault bumper[0] = set from 0 s //~ error LM0309
    fail mean_speed[0] from 0.5 s //~ error LM0309
}
