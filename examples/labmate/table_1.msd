import std.behaviors.collision_avoidance
import std.behaviors.collision_avoidance_as_printed
import std.behaviors.simple_navigation
import std.robots.labmate

// Table 1 of Sobh et al. 2000 turns towards what is close; its text means away from it. The same wall, to the right:

world wall_on_the_right {
    wall (0 m, -0.95 m) -> (12 m, -0.95 m)
}

arbiter as_meant on labmate {
    client avoid  = collision_avoidance priority 1
    client wander = simple_navigation   priority 9
}

arbiter as_printed on labmate {
    client avoid  = collision_avoidance_as_printed priority 1
    client wander = simple_navigation              priority 9
}

/// Turns away from the wall, and goes on along it or off.
scenario turns_away runs as_meant on labmate in wall_on_the_right {
    duration 30 s
    tick 20 ms
    place robot at (1 m, 0 m) heading -10 deg
    expect modes wander, avoid
    expect never front_bumper or back_bumper
    expect x > 4 m or y > 1 m
}

/// Turns towards the wall and on around, and gets nowhere.
scenario turns_towards runs as_printed on labmate in wall_on_the_right {
    duration 30 s
    tick 20 ms
    place robot at (1 m, 0 m) heading -10 deg
    expect modes wander, avoid
    expect never x > 3.5 m or y > 1 m
}
