import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario one_box runs obstacle_avoidance on j5 {
    duration 4 s
    place box mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    fail contact_force from 5 s //~ warning LM0807
    expect modes init, forward
}
