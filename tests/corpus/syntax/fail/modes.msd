import obstacle_id

behavior five on j5 {
    sense obstacle_id(left, right, force)
    entry init
    mode init {
        halt()
        1: after 2 s forward
        2: hit -> stop
    }
    mode forward {
        drive(26 cm/s
        1: heavy_obstacle -> stop
    }
    mode push requires else stop {
        arc(26 cm/s, radius: 1 m)
    }
    mode stop {
        halt()
        1 after 500 ms -> back_up
        2: again -> stop
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s ->
    }
    mode sound {
        drive(-20 cm/s)
        1: after 1.5 s -> stop
    }
}

property sound: never hit
