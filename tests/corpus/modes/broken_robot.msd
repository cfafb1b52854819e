// What is wrong with the robot is said once, and not again where it is used.
robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  traction 0.6 } //~ error LM0311
    sensor force: N  fails 0  = wedge.force //~ error LM0311
    sensor speed: knots in 0 .. 10  fails 0  = wheel.left.speed //~ error LM0302
    action drive(speed: knots) = body.velocity(speed, 0 deg/s) //~ error LM0302
    action halt() = body.stop()
}

behavior wander on rover {
    flag pressed = force > 115 N
    flag fast    = speed > 1 m/s and not failed(speed)

    entry go

    mode go requires force, speed else rest {
        drive(26 cm/s)
        1: pressed or fast -> again
        2: done            -> again
    }
    final mode rest { halt() }
}

scenario short_drive runs wander {
    duration 3 s
    fault force = 0 N
    expect never fast
}
