robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor force: N in 0 .. 400  fails -1 N, 0, 1 kN  = wedge.force //~ error LM0601, error LM0601
    action halt() = body.stop()
}
