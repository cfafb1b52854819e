// An interface promises readings from -1 to 1 m/s, always there; the robot gives others, and may lack them.
interface base {
    sensor speed: m/s in -1 .. 1
    action halt()
}

robot fast provides base {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor speed: cm/s in -300 .. 300  fails 0  = wheel.left.speed //~ error LM0312
    action halt() = body.stop()
}

robot unsure provides base {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    optional sensor speed: m/s in -1 .. 1  fails 0  = wheel.left.speed //~ error LM0312
    action halt() = body.stop()
}
