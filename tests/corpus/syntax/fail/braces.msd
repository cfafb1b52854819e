behavior unclosed_mode on j5 {
    entry a
    mode a {
        halt()
        1: hit -> b
    mode b {
        1: hit -> a
    }
}
behavior unclosed_behavior on j5 {
    entry a
    mode a { 1: hit -> a }

behavior extra_in_mode on j5 {
    mode a { halt() }
        1: hit -> b
    }
    mode b { 1: hit -> a }
}
behavior extra_in_behavior on j5 {
    mode a { halt() }
    }
    mode b { 1: hit -> a }
}
behavior extra_behind on j5 {
    mode a { halt() }
}
}
activity no_brace on j5
    entry a
    mode a = b
}
activity sound on j5 { mode a = b }
robot r {
    body differential_drive { mass 3 kg
    sensor s: m in 0 .. 3
    action halt()
}
behavior cut_off on j5 {
    mode a {
        1: hit
