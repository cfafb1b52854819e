import places
import std.behaviors.dock
import std.behaviors.seek_goal
import std.robots.labmate
import std.robots.scout

/// Around the table.
scenario labmate_seeks_the_goal runs seek_goal on labmate in furnished {
    duration 3 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    expect arrive
    expect goal_distance < 60 cm
    expect never front_bumper or back_bumper
}

scenario scout_seeks_the_goal runs seek_goal on scout in furnished {
    duration 3 min
    tick 20 ms
    place robot at (1.5 m, 4 m) heading -90 deg
    expect arrive
    expect goal_distance < 60 cm
    expect never bumper
}

/// From the other side, the goal behind it on its right.
scenario labmate_turns_to_the_goal runs seek_goal on labmate in furnished {
    duration 3 min
    tick 20 ms
    place robot at (1.5 m, 4.8 m) heading 90 deg
    expect turn_left
    expect arrive
    expect goal_distance < 60 cm
    expect never front_bumper or back_bumper
}

/// It does not know where the goal is for a while, and waits.
scenario scout_loses_the_goal runs seek_goal on scout in furnished {
    duration 3 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    fail goal_bearing from 2 s to 20 s
    expect seek -> wait within 2 s .. 2.1 s
    expect always wait within 3 s .. 19 s
    expect arrive
}

scenario labmate_docks runs dock on labmate in bare {
    duration 2 min
    tick 20 ms
    place robot at (2 m, 1.5 m) heading 120 deg
    expect approach -> rest
    expect goal_distance < 12 cm
}

scenario scout_docks runs dock on scout in bare {
    duration 2 min
    tick 20 ms
    place robot at (2 m, 1.5 m) heading 120 deg
    expect approach -> rest
    expect goal_distance < 12 cm
}
