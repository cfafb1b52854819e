// A car steers and does not turn in place; nothing of its wheels is measured.
robot car {
    body car_like { mass 500 kg  size (2 m, 1 m)  cycle 0.5 s  speed_limit 3 m/s  steering_limit 30 deg }

    sensor left_speed: m/s in -3 .. 3 fails 0 = wheel.left.speed //~ error LM0201
    sensor push: N in 0 .. 400 fails 0 = wedge.force //~ error LM0201

    action halt() = body.stop()
    action turn(angle: deg) -> done = body.rotate(angle) //~ error LM0201
    action steer(speed: m/s, angle: deg) = body.steer(speed, angle)
    action swerve(speed: m/s) = body.steer(speed, 1 m) //~ error LM0301
}

robot cart {
    body car_like { mass 500 kg  size (2 m, 1 m)  track 1 m } //~ error LM0201
}

robot wagon {
    body car_like { mass 500 kg  steering_limit 0 deg } //~ error LM0309
}

robot base {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }

    action steer(speed: m/s, angle: deg) = body.steer(speed, angle) //~ error LM0201
}
