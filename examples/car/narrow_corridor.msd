// A narrow corridor (figs. 7.3 and 7.4): by the fuzzy navigator of Khatoon and Ibraheem
// 2012, by the same as it is printed, and by a robot that seeks the open alone.

import std.activities.hybrid_navigation
import std.behaviors.fuzzy_navigation
import std.behaviors.fuzzy_navigation_as_printed
import std.behaviors.open_area_seeking
import std.robots.car
import worlds

scenario narrow_corridor_left_locally runs fuzzy_navigation on car in narrow_corridor_left {
    duration 4 min
    tick 100 ms
    place robot at (50 m, 14 m) heading 90 deg
    expect arrived
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_left_as_printed extends narrow_corridor_left_locally runs fuzzy_navigation_as_printed {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_left_in_the_open extends narrow_corridor_left_locally runs open_area_seeking {
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_right_locally runs fuzzy_navigation on car in narrow_corridor_right {
    duration 4 min
    tick 100 ms
    place robot at (50 m, 14 m) heading 90 deg
    expect arrived
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_right_as_printed extends narrow_corridor_right_locally runs fuzzy_navigation_as_printed {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_right_in_the_open extends narrow_corridor_right_locally runs open_area_seeking {
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_left_by_plan extends narrow_corridor_left_locally runs hybrid_navigation {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario narrow_corridor_right_by_plan extends narrow_corridor_right_locally runs hybrid_navigation {
    expect arrived
    expect never front_bumper or back_bumper
}
