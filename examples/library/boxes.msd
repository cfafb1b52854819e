import std.behaviors.push
import std.robots.j5
import std.robots.scout

scenario j5_pushes runs push on j5 {
    duration 20 s
    place box mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    place box mass 90 kg size (0.4 m, 0.6 m) at 1.6 m ahead
    expect modes approach, push, back_up, turn_away
    expect never overloaded before 6 s
    expect overloaded
}

scenario scout_pushes runs push on scout {
    duration 40 s
    place box mass 5 kg size (0.3 m, 0.3 m) at 0.75 m ahead
    place box mass 40 kg size (0.3 m, 0.3 m) at 1.3 m ahead
    expect modes approach, push, back_up, turn_away, approach
    expect never overloaded before 6 s
    expect overloaded
    expect y > 1 m
}
