// A tick in the wrong unit.
import std.behaviors.obstacle_avoidance

scenario long_day runs obstacle_avoidance { //~ error LM0803
    duration 10 min
    tick 10 us
}
