// A door that the planner takes for open and that is shut: the car gets no further, plans anew with what it has seen, and
// goes the long way around.

import std.activities.hybrid_navigation
import std.robots.car

world two_rooms {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (0 m, 50 m) -> (80 m, 50 m)
    door at (30 m, 50 m) width 14 m heading 0 deg
    goal (30 m, 80 m)
}

scenario shut_door runs hybrid_navigation on car in two_rooms {
    duration 6 min
    tick 100 ms
    place robot at (30 m, 15 m) heading 90 deg
    expect modes plan, leg
    expect leg -> plan
    expect arrived
}

/// The same with the door open.
world two_rooms_open {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (0 m, 50 m) -> (80 m, 50 m)
    door at (30 m, 50 m) width 14 m heading 0 deg open
    goal (30 m, 80 m)
}

scenario open_door extends shut_door in two_rooms_open {
    expect never plan within 1 s .. 6 min
    expect arrived within 0 s .. 2 min
}
