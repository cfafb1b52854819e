import std.behaviors.obstacle_avoidance
import std.behaviors.obstacle_manipulation
import std.robots.j5

/// A room of boxes: light ones, and two that are too heavy to be pushed.
world room {
    wall (0 m, 0 m) -> (10 m, 0 m) -> (10 m, 8 m) -> (0 m, 8 m) -> (0 m, 0 m)
    box mass 20 kg size (0.5 m, 0.5 m) at (4 m, 4 m)
    box mass 30 kg size (0.4 m, 0.6 m) at (6 m, 2.5 m)
    box mass 25 kg size (0.5 m, 0.5 m) at (3 m, 6 m)
    box mass 200 kg size (0.6 m, 0.6 m) at (7.5 m, 5.5 m)
    box mass 200 kg size (0.6 m, 0.6 m) at (2.5 m, 2 m)
}

/// Avoidance (Born & Wright 2007, fig. 6): away from everything it runs into.
scenario avoidance runs obstacle_avoidance on j5 in room {
    duration 10 min
    tick 10 ms
    place robot at (1.2 m, 4 m)
    expect forward -> stop
    expect random_turn -> forward
    expect back_up within 9 min .. 10 min
}

/// Manipulation (fig. 7): what is light is pushed.
scenario manipulation runs obstacle_manipulation on j5 in room {
    duration 10 min
    tick 10 ms
    place robot at (1.2 m, 4 m)
    expect forward -> push
    expect push -> forward
    expect heavy_obstacle
    expect back_up within 9 min .. 10 min
}
