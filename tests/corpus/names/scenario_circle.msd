import std.behaviors.obstacle_avoidance

scenario one extends two { //~ error LM0205
    duration 3 s
}

scenario two extends one {
    seed 4
}

scenario three extends two {
    expect modes init
}
