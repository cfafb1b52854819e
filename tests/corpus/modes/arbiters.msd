robot cart runs cart_drive {
    body differential_drive { mass 20 kg  size (0.6 m, 0.5 m)  track 0.4 m  traction 0.5 }
    sensor bumper: contact  fails set  = bumper.front
    action go(distance: m) -> done
    action stop()
    action roll(distance: m) -> done = body.travel(distance, 20 cm/s)
    action brake() = body.stop()
    action halt() = stop()
    action lost_way() = nowhere() //~ error LM0201
    action twice() = halt() //~ error LM0309
    action wrong() = stop(3 m) //~ error LM0307
}

robot other {
    action wait()
}

behavior cart_drive on cart {
    entry idle

    mode idle {
        brake()
        1: command is go and not bumper  -> moving
        2: command is gone               -> moving //~ error LM0201
    }
    mode moving {
        roll(command.distance)
        1: not command is go -> idle
        2: state is sleepy   -> idle //~ error LM0201
        3: failed(won)       -> idle //~ error LM0309
    }
}

behavior onward on cart {
    entry ahead

    final mode ahead { go(0 m) }
}

behavior chatty on cart {
    entry ahead

    mode ahead {
        on enter { stop() }
        go(0 m)
        1: won -> ahead
    }
}

behavior elsewhere on other {
    entry rest

    final mode rest { wait() }
}

arbiter crew on cart {
    emergency bumper -> brake()
    emergency bumper -> stop() //~ error LM0903
    emergency bumper -> jump() //~ error LM0201
    client one     = onward    priority 1
    client two     = onward    priority 11 //~ error LM0309
    client three   = nobody    priority 3 //~ error LM0201
    client one     = onward    priority 4 //~ error LM0202
    client far     = elsewhere priority 5 //~ error LM0204
    client loud    = chatty    priority 6 //~ error LM0309
    client nobody  = onward    priority 7 //~ error LM0309
    client late    = onward    priority 2 else 3 //~ error LM0309
    ties fairly //~ error LM0201
}

arbiter empty on cart { //~ error LM0311
}

arbiter homeless { //~ error LM0311
    client one = onward priority 1
}

arbiter tied on cart {
    client one = onward priority 1 when bumper else 4
    client two = onward priority 4 //~ warning LM0901
}

arbiter crowded on cart {
    client low  = onward priority 5 //~ warning LM0902
    client high = onward priority 2
}

robot twin runs cart_drive { //~ error LM0204
    body differential_drive { mass 20 kg  size (0.6 m, 0.5 m)  track 0.4 m  traction 0.5 }
    sensor state: m in 0 .. 1  fails 0 //~ error LM0309
    action go()
}

robot selfish runs selfish_drive {
    body differential_drive { mass 20 kg  size (0.6 m, 0.5 m)  track 0.4 m  traction 0.5 }
    action go()
}

behavior selfish_drive on selfish {
    entry ever

    final mode ever { go() } //~ error LM0309
}
