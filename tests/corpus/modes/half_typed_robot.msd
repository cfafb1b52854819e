// One fault in a robot: neither its other parts nor what uses the broken one is reported.
interface base {
    action halt()
    action drive(speed: m/s)
}

robot rover provides base {
    body differential_drive { mass 20 kg  size (0.5 m 0.4 m)  track 0.35 m  traction 0.6 } //~ error LM0101
    sensor force N in 0 .. 400  fails 0  = wedge.force //~ error LM0101
    action halt() = body.stop()
    action drive(speed m/s) = body.velocity(speed, 0 deg/s) //~ error LM0101
}

behavior wander on rover {
    flag pressed = force > 115 N

    entry go

    mode go requires force else rest {
        drive(26 cm/s)
        1: pressed       -> again
        2: failed(force) -> again
    }
    final mode rest { halt() }
}

scenario short_drive runs wander {
    duration 3 s
    fault force = 0 N
}
