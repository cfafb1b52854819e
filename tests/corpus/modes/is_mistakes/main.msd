// `is` asks for a term of the variable that a sensor feeds.
import levels

robot pusher {
    sensor x: 1 in 0 .. 10 fails 0
    sensor y: 1 in 0 .. 10 fails 0
    sensor z[2]: 1 in 0 .. 10 fails 0
    sensor idle: 1 in 0 .. 10 fails 0
    sensor broken: parsec in 0 .. 1 //~ error LM0302
    action halt()
}

behavior asks on pusher {
    sense n(x, y)
    sense m(z[0], x)

    flag up_and_down = up or down

    entry go

    mode go {
        halt()
        1: idle is low                  -> again //~ error LM0309
        2: z[1] is low                  -> again //~ error LM0309
        3: z is low                     -> again //~ error LM0309
        4: x is hihg                    -> again //~ error LM0201
        5: one is low                   -> again //~ error LM0206
        6: n.one is low and x is any of {low, high} -> again
        7: y is flat                    -> again //~ error LM0105
        8: broken is low                -> again
        9: xx is low                    -> again //~ error LM0201
        10: up is low                   -> again //~ error LM0309
        11: other_robot.mode is go      -> again //~ error LM0201
        12: up_and_down                 -> again
    }
}

behavior broken_sense on pusher {
    sense n(broken, y)

    entry go

    mode go {
        halt()
        1: one is low       -> again
        2: n.one is low     -> again
        3: up               -> again
    }
}
