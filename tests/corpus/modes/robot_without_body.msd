// Said once, not for each action.
robot rover { //~ error LM0311
    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
}

behavior wander on rover {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
}
