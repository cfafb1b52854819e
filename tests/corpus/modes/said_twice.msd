robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6  mass 30 kg } //~ error LM0310
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 } //~ error LM0310
    action halt() = body.stop()
}
