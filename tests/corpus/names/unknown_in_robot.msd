robot rover provides mobile_base { //~ error LM0201
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  tracks 0.35 m  traction 0.6 } //~ error LM0201
    sensor force: N in 0 .. 400  fails 0  = wedge.froce //~ error LM0201
    action halt() = body.halt() //~ error LM0201
    action drive(speed: m/s) = body.velocity(velocity, 0 deg/s) //~ error LM0201
}

robot walker {
    body legs { count 2 } //~ error LM0201
    action halt() = body.stop()
}
