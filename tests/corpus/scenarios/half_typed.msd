// The duration is there, only not readable.
import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario short_drive runs obstacle_avoidance on j5 {
    duration ten s //~ error LM0101
    place robot at (0 m, 0 m) heading 0 deg
    expect modes init, forward
}
