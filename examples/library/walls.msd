import places
import std.behaviors.follow_corridor
import std.behaviors.follow_wall
import std.robots.labmate
import std.robots.scout

/// Around the room and around the corner in it, the wall on its right.
scenario labmate_follows_the_wall runs follow_wall on labmate in angled {
    duration 4 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7.5 m and y > 5.5 m
    expect x < 6.5 m and y > 5.5 m
    expect x < 1.5 m and y > 2.5 m
    expect x < 1.5 m and y < 1.5 m
    expect never x < 5 m and y > 4 m
    expect never right < 30 cm
    expect never front_bumper or back_bumper
}

scenario scout_follows_the_wall runs follow_wall on scout in angled {
    duration 4 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect x > 7.5 m and y > 5.5 m
    expect x < 6.5 m and y > 5.5 m
    expect x < 1.5 m and y > 2.5 m
    expect x < 1.5 m and y < 1.5 m
    expect never x < 5 m and y > 4 m
    expect never right < 30 cm
    expect never bumper
}

/// To the end of the corridor, and back.
scenario labmate_follows_the_corridor runs follow_corridor on labmate in corridor {
    duration 4 min
    tick 20 ms
    place robot at (1.5 m, 1 m) heading 10 deg
    expect x > 16 m
    expect x < 2 m within 2 min .. 4 min
    expect never front_bumper or back_bumper
}

scenario scout_follows_the_corridor runs follow_corridor on scout in corridor {
    duration 4 min
    tick 20 ms
    place robot at (1.5 m, 1 m) heading 10 deg
    expect x > 16 m
    expect x < 2 m within 2 min .. 4 min
    expect never bumper
}
