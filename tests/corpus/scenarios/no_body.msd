// Actions without a body are the user's to write; then there is nothing to simulate.
robot cart {
    sensor force: N in 0 .. 400  fails 0
    action halt()
}

behavior wait on cart {
    entry look

    mode look {
        halt()
        1: force > 10 N -> again
    }
}

scenario short_wait runs wait { //~ error LM0311
    duration 3 s
}
