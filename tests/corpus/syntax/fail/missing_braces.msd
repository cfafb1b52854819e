behavior no_brace on j5
    entry a
    mode a { halt() }
    mode b { halt() }
}
behavior no_mode_brace on j5 {
    mode a
        halt()
        1: hit -> b
    }
    mode b {{ halt() }
    mode c { 1: x is any of {low, med -> a }
    mode d { 1: x is any of low, med} -> a }
    mode e { halt() }
}
team no_brace_either
    robot a = j5 runs b
}
behavior sound on j5 { mode a { halt() } }
behavior {
    mode a { 1: hit b }
}
