// A tick in the wrong unit.
import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario long_day runs obstacle_avoidance on j5 { //~ error LM0803
    duration 10 min
    tick 10 us
}
