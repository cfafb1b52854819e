import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario short_drive runs obstacle_avoidance on j5 {
    duration 3 s
    expect never contact_force //~ error LM0306
    expect contact_force > 500 N //~ warning LM0305
    expect always init before 2 m //~ error LM0301
    expect stop and 3 //~ error LM0306
}
