import places
import std.behaviors.explore
import std.behaviors.back_and_forth
import std.behaviors.seek_open_area
import std.robots.j5
import std.robots.labmate
import std.robots.scout

scenario labmate_seeks_open_area runs seek_open_area on labmate in furnished {
    duration 5 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m
    expect never front_bumper or back_bumper
}

scenario scout_seeks_open_area runs seek_open_area on scout in furnished {
    duration 5 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m
    expect never bumper
}

scenario labmate_explores runs explore on labmate in furnished {
    duration 10 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect x > 7 m and y < 3 m
    expect never front_bumper or back_bumper
}

scenario scout_explores runs explore on scout in furnished {
    duration 10 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect x > 7 m and y < 3 m
    expect never bumper
}

/// To and fro between two walls.
scenario j5_goes_back_and_forth runs back_and_forth on j5 in bare {
    duration 2 min
    place robot at (2 m, 3 m)
    expect modes onward, back_up, about, onward, back_up, about, onward
}

scenario labmate_goes_back_and_forth runs back_and_forth on labmate in bare {
    duration 2 min
    tick 20 ms
    place robot at (2 m, 3 m)
    expect x > 6.5 m
    expect x < 1.5 m
    expect never front_bumper or back_bumper
}

scenario scout_goes_back_and_forth runs back_and_forth on scout in bare {
    duration 2 min
    tick 20 ms
    place robot at (2 m, 3 m)
    expect x > 7 m
    expect x < 1 m
    expect never bumper
}
