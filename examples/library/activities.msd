import places
import std.activities.clear_area
import std.activities.patrol_area
import std.activities.return_home
import std.activities.search
import std.behaviors.seek_goal
import std.robots.j5
import std.robots.labmate
import std.robots.scout

scenario labmate_patrols runs patrol_area on labmate in furnished {
    duration 15 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect modes along, look, across, along
    expect along and x > 7 m and y < 3 m
    expect along and x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect across and front > 1.5 m and right > 1.5 m
    expect never front_bumper or back_bumper
}

scenario scout_patrols runs patrol_area on scout in furnished {
    duration 15 min
    tick 20 ms
    place robot at (2 m, 2 m)
    expect modes along, look, across, along
    expect along and x > 7 m and y < 3 m
    expect along and x > 7 m and y > 5 m
    expect x < 3 m and y > 5 m
    expect across and front > 1.5 m and right > 1.5 m
    expect never bumper
}

scenario labmate_searches runs search on labmate in furnished {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 6.5 m)
    expect modes explore, approach, dock, found
    expect goal_distance < 12 cm
    expect never front_bumper or back_bumper
}

scenario scout_searches runs search on scout in furnished {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 6.5 m)
    expect modes explore, approach, dock, found
    expect goal_distance < 12 cm
    expect never bumper
}

/// It knows how far its goal is, but not where: it gives up for a while, and finds it later.
scenario scout_searches_on runs search on scout in furnished {
    duration 20 min
    tick 20 ms
    place robot at (1.5 m, 6.5 m)
    fail goal_bearing from 0 s to 10 min
    expect approach -> explore within 0 s .. 10 min
    expect found within 10 min .. 20 min
    expect goal_distance < 12 cm
    expect never bumper
}

/// What `return_home` is for: alone, `seek_goal` stays in the pocket.
scenario labmate_is_caught runs seek_goal on labmate in pocket {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    expect never arrive
}

scenario labmate_returns_home runs return_home on labmate in pocket {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    expect modes home, along, home
    expect rest
    expect goal_distance < 12 cm
    expect never front_bumper or back_bumper
}

scenario scout_is_caught runs seek_goal on scout in pocket {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    expect never arrive
}

scenario scout_returns_home runs return_home on scout in pocket {
    duration 10 min
    tick 20 ms
    place robot at (1.5 m, 4 m)
    expect modes home, along, home
    expect rest
    expect goal_distance < 12 cm
    expect never bumper
}

/// It loses its goal while it docks, and drives there again.
scenario scout_docks_again runs return_home on scout in bare {
    duration 3 min
    tick 20 ms
    place robot at (2 m, 3 m)
    fail goal_bearing from 17 s to 90 s
    expect modes home, dock, home, dock, rest
    expect goal_distance < 12 cm
}

/// Had it found nothing to push, it would rest after three minutes.
scenario j5_clears runs clear_area on j5 in bare {
    duration 30 min
    tick 20 ms
    place robot at (1 m, 3 m)
    place box mass 30 kg size (0.4 m, 0.6 m) at (3 m, 3 m)
    place box mass 30 kg size (0.4 m, 0.6 m) at (5 m, 2 m) heading 20 deg
    expect held(sweep.mode is push, 5 s)
    expect never rest before 190 s
    expect rest
}

scenario scout_clears runs clear_area on scout in bare {
    duration 30 min
    tick 20 ms
    place robot at (1 m, 3 m)
    place box mass 8 kg size (0.3 m, 0.3 m) at (3 m, 3 m)
    place box mass 8 kg size (0.3 m, 0.3 m) at (5 m, 2 m) heading 20 deg
    expect held(sweep.mode is push, 5 s)
    expect never rest before 190 s
    expect rest
}
