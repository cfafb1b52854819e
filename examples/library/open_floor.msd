import places
import std.behaviors.explore
import std.behaviors.back_and_forth
import std.behaviors.seek_open_area
import std.robots.j5
import std.robots.labmate
import std.robots.scout

/// Round about the table.
scenario labmate_seeks_open_area runs seek_open_area on labmate in furnished {
    duration 5 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect x < 3 m and y < 3 m within 1 min .. 5 min
    expect never front_bumper or back_bumper
}

scenario scout_seeks_open_area runs seek_open_area on scout in furnished {
    duration 5 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect x < 3 m and y < 3 m within 1 min .. 5 min
    expect never bumper
}

/// Around the bends of a corridor, before anything is in the way.
scenario labmate_keeps_to_the_open runs seek_open_area on labmate in corridor {
    duration 1 min
    tick 20 ms
    place robot at (1.5 m, 1 m) heading 10 deg
    expect x > 14 m
    expect never turn_left or turn_right
}

scenario scout_keeps_to_the_open runs seek_open_area on scout in corridor {
    duration 1 min
    tick 20 ms
    place robot at (1.5 m, 1 m) heading 10 deg
    expect x > 14 m
    expect never turn_left or turn_right
}

/// From the end of a pocket, where it has to turn until there is room.
scenario labmate_leaves_the_pocket runs seek_open_area on labmate in pocket {
    duration 3 min
    tick 20 ms
    place robot at (5.5 m, 4 m)
    expect x < 3 m
    expect never front_bumper or back_bumper
}

scenario scout_leaves_the_pocket runs seek_open_area on scout in pocket {
    duration 3 min
    tick 20 ms
    place robot at (5.5 m, 4 m)
    expect x < 3 m
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
