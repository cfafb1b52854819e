interface base {
    sensor force: N in 0 .. 400
    action halt()
    action drive(speed: m/s)
    action arc(speed: m/s, radius: m)
    action turn(angle: deg) -> done
}

robot rover provides base { //~ error LM0312, error LM0312
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action arc(speed: m/s) = body.velocity(speed, 90 deg/s) //~ error LM0312
    action turn(angle: deg) = body.rotate(angle) //~ error LM0312
}
