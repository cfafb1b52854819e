interface base {
    sensor force: N //~ error LM0311
    action halt() = body.stop() //~ error LM0311
}

robot rover {
    body differential_drive { mass 20 kg } //~ error LM0311
    action halt() = body.stop()
    action drive(speed: m/s) //~ error LM0311
}
