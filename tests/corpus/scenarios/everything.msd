import std.behaviors.obstacle_manipulation
import std.robots.j5

world hallway {
    wall (-2 m, -2 m) -> (12 m, -2 m)
    wall (-2 m, 2 m) -> (5 m, 2 m) -> (5 m, 4 m)
    box crate mass 30 kg size (0.4 m, 0.6 m) at (4 m, 1 m) heading 30 deg
    goal (11 m, 1 m)
}

scenario bare runs obstacle_manipulation {
    duration 1 s
}

/// Everything a scenario can say.
scenario full runs obstacle_manipulation on j5 in hallway {
    duration 10 s   tick 20 ms   seed 7
    place robot at (0 m, 0.5 m) heading -10 deg
    place box light mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    place box mass 90 kg size (0.4 m, 0.6 m) at (8 m, 0 m) heading 1 rad
    fault left_wheel_acceleration = 0 from 2 s to 3 s
    fault right_wheel_acceleration = any from 2 s
    fail contact_force to 1 s
    expect modes init, forward
    expect init -> forward within 1.9 s .. 2.1 s
    expect init -> forward
    expect forward within 2 s .. 4 s
    expect contact_force < 400 N
    expect never heavy_obstacle and not push before 1 s
    expect always contact_force < 400 N after 0 s
    expect never (stop or obstacle_id.heavy_obstacle) within 0 s .. 1 s
}

scenario varied extends full {
    seed 8
    place box light mass 40 kg size (0.4 m, 0.6 m) at 1 m ahead
    expect modes init, forward
}
