import std.behaviors.collision_avoidance
import std.behaviors.simple_navigation
import std.robots.labmate

/// Hardly more room than the robot takes.
world closet {
    wall (-0.65 m, -0.6 m) -> (0.65 m, -0.6 m) -> (0.65 m, 0.6 m) -> (-0.65 m, 0.6 m) -> (-0.65 m, -0.6 m)
}

arbiter careful on labmate {
    client avoid  = collision_avoidance priority 1
    client wander = simple_navigation   priority 9
}

/// Close on all sides: the robot stays where it is.
scenario enclosed runs careful on labmate in closet {
    duration 20 s
    tick 20 ms
    expect modes avoid
    expect never front_bumper or back_bumper
    expect never x > 5 cm or x < -5 cm
}
