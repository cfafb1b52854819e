robot rover {
    body differential_drive { mass 200 N  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 } //~ error LM0301
    sensor force: m/s^2 in 0 .. 400  fails 0  = wedge.force //~ error LM0301
    sensor speed: m/s in -1 .. 1  fails 0 m  = wheel.left.speed  noise 3 cm //~ error LM0301, error LM0301
    action halt() = body.velocity(0 deg/s, 0 m/s) //~ error LM0301, error LM0301
    action turn(angle: deg/s) -> done = body.rotate(angle) //~ error LM0301
}
