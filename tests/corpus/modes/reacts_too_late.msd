// Robots that can be at what they see before they stand, and some that cannot.

robot runner {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor ahead: m in 10 cm .. 5 m  fails 10 cm  = ring.range  accuracy 5 cm  period 100 ms
    sensor around[4]: m in 10 cm .. 5 m  fails 10 cm  = ring.range  period 50 ms  beam 120 deg
    logical smooth = ahead within 1 s
    action stop() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action swerve(speed: m/s) = body.velocity(speed, 90 deg/s)
    action roll(speed: m/s) = drive(speed)
}

behavior stages on runner {
    flag near = ahead < 60 cm

    entry fast

    mode fast {
        drive(1.5 m/s) //~ warning LM0701
        1: near -> slow
    }
    mode slow {
        roll(0.2 m/s)
        1: not (ahead > 20 cm) -> back //~ warning LM0416
    }
    mode back {
        drive(-2 m/s) //~ warning LM0701
        1: around[1] < 30 cm -> waiting
        2: after 10 s        -> waiting
    }
    mode waiting {
        drive(0.5 m/s) //~ warning LM0701
        1: held(near, 2 s) -> averaging
    }
    mode averaging {
        drive(0.5 m/s) //~ warning LM0701
        1: smooth < 30 cm -> brief
    }
    // It does not last until it gets there.
    mode brief {
        drive(1.5 m/s)
        1: near         -> slow
        2: after 300 ms -> careful
    }
    mode careful {
        drive(0.5 m/s)
        1: near -> slow
    }
}

// Where it may steer away, it need not stand.
behavior steering on runner {
    entry fast

    mode fast {
        drive(1.2 m/s)
        1: ahead < 60 cm -> aside
    }
    mode aside {
        swerve(1.2 m/s)
        1: after 1 s -> fast
    }
}

behavior onward on runner {
    entry go

    final mode go { drive(1.5 m/s) } //~ warning LM0701
}

behavior shy on runner {
    flag near = ahead < 60 cm

    entry watch

    final mode watch {
        decide (near) {
            (set  ) => stop()
            (clear) => nothing
        }
    }
}

arbiter crew on runner {
    client careful = shy    priority 1
    client go      = onward priority 5
}
