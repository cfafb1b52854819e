import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario one_box runs obstacle_avoidance on j5 {
    duration 10 s
    place box mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    expect modes init, forward, stop
    expect never stop and forward //~ warning LM0806
}
