import base

robot rover provides base {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor force: N in 0 .. 400  fails 0  = wedge.force
    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
}
