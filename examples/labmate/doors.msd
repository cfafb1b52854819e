import door_finding
import std.behaviors.collision_avoidance
import std.robots.labmate
import worlds

/// Experiment 3 (Sobh et al. 2000): through the doors of a hallway; with all seeds from 1 to 100 through both.
arbiter passing on labmate {
    emergency rising(front_bumper) -> brake()
    emergency rising(back_bumper)  -> brake()
    client avoid = collision_avoidance priority 1
    client find  = door_finding        priority 5
}

scenario two_doors runs passing on labmate in hallway {
    duration 3 min
    tick 20 ms
    place robot at (1 m, 2 m)
    expect never front_bumper or back_bumper
    expect x > 6 m
    expect x > 11 m
}
