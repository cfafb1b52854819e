robot cart {
    body differential_drive { mass 30 kg  size (60 cm, 50 cm)  track 45 cm  traction 0.5 }
    sensor left_speed:  m/s in -1 .. 1 fails 0 = wheel.left.speed
    sensor right_speed: m/s in -1 .. 1 fails 0 = wheel.right.speed //~ info LM0212
    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
}

behavior wander on cart {
    entry go

    mode go {
        drive(26 cm/s)
        1: left_speed < 0.1 m/s and after 1 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
