import std.behaviors.collision_avoidance
import std.behaviors.simple_navigation
import std.robots.labmate
import worlds

/// Experiment 1 (Sobh et al. 2000): always onward, unless something is close.
arbiter wandering on labmate {
    emergency rising(front_bumper) -> brake()
    emergency rising(back_bumper)  -> brake()
    client avoid  = collision_avoidance priority 1
    client wander = simple_navigation   priority 9
}

scenario in_the_lab runs wandering on labmate in lab {
    duration 10 min
    tick 20 ms
    place robot at (1.2 m, 5 m) heading -20 deg
    expect never front_bumper or back_bumper
}

scenario in_the_hallway runs wandering on labmate in hallway {
    duration 10 min
    tick 20 ms
    place robot at (1 m, 2 m)
    expect never front_bumper or back_bumper
}
