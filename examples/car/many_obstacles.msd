// Many obstacles (figs. 7.5 and 7.6): by the fuzzy navigator of Khatoon and Ibraheem
// 2012, by the same as it is printed, and by a robot that seeks the open alone.

import std.activities.hybrid_navigation
import std.behaviors.fuzzy_navigation
import std.behaviors.fuzzy_navigation_as_printed
import std.behaviors.open_area_seeking
import std.robots.car
import worlds

scenario many_obstacles_right_locally runs fuzzy_navigation on car in many_obstacles_right {
    duration 4 min
    tick 100 ms
    place robot at (50 m, 10 m) heading 90 deg
    expect arrived
    expect never front_bumper or back_bumper
}

scenario many_obstacles_right_as_printed extends many_obstacles_right_locally runs fuzzy_navigation_as_printed {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario many_obstacles_right_in_the_open extends many_obstacles_right_locally runs open_area_seeking {
    expect never front_bumper or back_bumper
}

scenario many_obstacles_center_locally runs fuzzy_navigation on car in many_obstacles_center {
    duration 4 min
    tick 100 ms
    place robot at (50 m, 10 m) heading 90 deg
    expect arrived
    expect never front_bumper or back_bumper
}

scenario many_obstacles_center_as_printed extends many_obstacles_center_locally runs fuzzy_navigation_as_printed {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario many_obstacles_center_in_the_open extends many_obstacles_center_locally runs open_area_seeking {
    expect never front_bumper or back_bumper
}

scenario many_obstacles_right_by_plan extends many_obstacles_right_locally runs hybrid_navigation {
    expect arrived
    expect never front_bumper or back_bumper
}

scenario many_obstacles_center_by_plan extends many_obstacles_center_locally runs hybrid_navigation {
    expect arrived
    expect never front_bumper or back_bumper
}
