import std.behaviors.obstacle_avoidance
import std.robots.j5

robot rover {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    action halt() = body.stop()
}

scenario short_drive runs obstacle_avoidance on rover { //~ error LM0204
    duration 3 s
    expect modes init, forward
}
