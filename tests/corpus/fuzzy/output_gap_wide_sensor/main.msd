import pace

robot cart {
    sensor ahead: m in 0 .. 20  fails 0
    action go(speed: m/s)
}

behavior creep on cart {
    sense pace(ahead) //~ error LM0527

    entry go_on

    mode go_on {
        go(speed)
        1: after 5 s -> again
    }
}
