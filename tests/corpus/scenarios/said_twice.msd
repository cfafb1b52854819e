import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario short_drive runs obstacle_avoidance on j5 {
    duration 3 s
    duration 4 s //~ error LM0310
    tick 10 ms
    tick 20 ms //~ error LM0310
    seed 1
    seed 2 //~ error LM0310
    place robot at (0 m, 0 m)
    place robot at (1 m, 0 m) heading 90 deg //~ error LM0310
}

world hallway {
    goal (3 m, 0 m)
    goal (4 m, 0 m) //~ error LM0310
}
