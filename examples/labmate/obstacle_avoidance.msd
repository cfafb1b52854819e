import std.behaviors.obstacle_avoidance
import std.robots.labmate
import worlds

// The behavior of J5 (Born & Wright 2007, fig. 6), unchanged: LABMATE sees what J5 runs into.

scenario in_the_lab runs obstacle_avoidance on labmate in lab {
    duration 10 min
    tick 20 ms
    place robot at (1.2 m, 5 m) heading -20 deg
    expect y > 6 m or y < 2 m
    expect back_up within 9 min .. 10 min
    expect never front_bumper or back_bumper
}

scenario in_the_hallway runs obstacle_avoidance on labmate in hallway {
    duration 10 min
    tick 20 ms
    place robot at (1 m, 2 m)
    expect back_up within 9 min .. 10 min
    expect never front_bumper or back_bumper
}
