// The manipulation experiment (Born & Wright 2007, section 4, figs. 10 to 12).
//
// A 30 kg box stands 75 cm ahead of the robot, a 90 kg box 75 cm behind it. The robot drives ahead at 26 cm/s. At
// about 5 s it hits the first box, does not call it heavy, and pushes it. At about 8 s the first box meets the second
// one; both together are heavy, so the robot stops, and backs up when the stop timer expires.
//
// Masses, distances, speed and times are the paper's. The boxes' sizes are ours.

import std.behaviors.obstacle_manipulation
import std.robots.j5

/// Pushes the light box, refuses the heavy one (fig. 12).
scenario manipulation runs obstacle_manipulation on j5 {
    duration 10 s  tick 10 ms  seed 1
    place robot at (0 m, 0 m) heading 0 deg
    place box light mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    place box heavy mass 90 kg size (0.4 m, 0.6 m) at 1.5 m ahead

    expect modes init, forward, push, stop, back_up
    expect init -> forward within 1.9 s .. 2.1 s
    expect forward -> push within 4.5 s .. 5.5 s
    expect push -> stop within 7.5 s .. 8.5 s
    expect never heavy_obstacle before 7.5 s
}
