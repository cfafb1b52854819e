import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario nothing { //~ error LM0311
    duration 3 s
}

scenario endless runs obstacle_avoidance on j5 { //~ error LM0311
    expect modes init
}

scenario still_endless extends endless {
    expect modes init
}
