import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario short_drive runs obstacle_avoidance on j5 {
    duration 3 s
    expect modes init, forward, push //~ error LM0201
    expect forward -> push within 1 s .. 2 s //~ error LM0201
    expect never push and blocked //~ error LM0201
}
