// A blocked corridor (fig. 7.7 of Khatoon and Ibraheem 2012). The fuzzy navigator is caught in it, as the paper says: every
// way out leads away from the goal. A robot that seeks the open alone turns around in it and comes out again.

import std.activities.hybrid_navigation
import std.behaviors.fuzzy_navigation
import std.behaviors.fuzzy_navigation_as_printed
import std.behaviors.open_area_seeking
import std.robots.car
import worlds

scenario blocked_corridor_locally runs fuzzy_navigation on car in blocked_corridor {
    duration 4 min
    tick 100 ms
    place robot at (50 m, 10 m) heading 90 deg
    expect never arrived
}

scenario blocked_corridor_as_printed extends blocked_corridor_locally runs fuzzy_navigation_as_printed {
    expect never arrived
}

scenario blocked_corridor_in_the_open extends blocked_corridor_locally runs open_area_seeking {
    expect never front_bumper or back_bumper
}

/// A planner on the map leads around it.
scenario blocked_corridor_by_plan extends blocked_corridor_locally runs hybrid_navigation {
    expect arrived
    expect never front_bumper or back_bumper
}
