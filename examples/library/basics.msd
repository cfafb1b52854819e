import places
import std.behaviors.arc
import std.behaviors.drive
import std.behaviors.halt
import std.behaviors.turn
import std.robots.j5
import std.robots.labmate
import std.robots.scout

scenario labmate_halts runs halt on labmate in bare {
    duration 10 s
    tick 20 ms
    place robot at (2 m, 3 m)
    expect never x > 2.01 m or x < 1.99 m or y > 3.01 m or y < 2.99 m
}

scenario scout_halts runs halt on scout in bare {
    duration 10 s
    tick 20 ms
    place robot at (2 m, 3 m)
    expect never x > 2.01 m or x < 1.99 m or y > 3.01 m or y < 2.99 m
}

scenario j5_drives runs drive on j5 in bare {
    duration 40 s
    place robot at (2 m, 3 m)
    expect onward -> stopped within 20 s .. 24 s
}

scenario labmate_drives runs drive on labmate in bare {
    duration 40 s
    tick 20 ms
    place robot at (2 m, 3 m)
    expect onward -> stopped within 19 s .. 22 s
    expect x > 7 m
    expect never front_bumper
}

scenario scout_drives runs drive on scout in bare {
    duration 40 s
    tick 20 ms
    place robot at (2 m, 3 m)
    expect onward -> stopped within 21 s .. 24 s
    expect x > 7.4 m
    expect never bumper
}

scenario j5_circles runs arc on j5 in bare {
    duration 2 min
    place robot at (3 m, 1 m) heading -80 deg
    expect modes leftward, back_up_right, rightward, back_up_left, leftward
}

scenario labmate_circles runs arc on labmate in bare {
    duration 2 min
    tick 20 ms
    place robot at (4 m, 4.5 m)
    expect leftward -> back_up_right
    expect rightward within 60 s .. 120 s
    expect rightward and y < 4 m within 60 s .. 120 s
    expect never front_bumper or back_bumper
}

scenario scout_circles runs arc on scout in bare {
    duration 2 min
    tick 20 ms
    place robot at (4 m, 2 m)
    expect y > 3.8 m
    expect never blocked
}

scenario labmate_looks_around runs turn on labmate in bare {
    duration 30 s
    tick 20 ms
    place robot at (2 m, 3 m)
    expect heading > 80 deg within 3 s .. 8 s
    expect heading < -80 deg
    expect never x > 2.1 m or x < 1.9 m
}

scenario j5_looks_around runs turn on j5 in bare {
    duration 30 s
    place robot at (2 m, 3 m)
    expect look -> on_around within 1.9 s .. 2.1 s
    expect on_around -> look within 3 s .. 12 s
}
