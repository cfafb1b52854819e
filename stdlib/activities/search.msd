// All distances and times are ours.
import std.behaviors.dock
import std.behaviors.explore
import std.behaviors.halt
import std.behaviors.seek_goal
import std.interfaces.located_base

/// Explores until its goal is near, goes there and docks.
activity search on located_base {
    flag near = goal_distance < 2.5 m
    flag lost = goal_distance > 4 m or failed(goal_distance) or failed(goal_bearing)

    entry explore

    mode explore = explore {
        1: held(near, 500 ms) -> approach
    }
    mode approach = seek_goal {
        1: done            -> dock
        2: held(lost, 5 s) -> explore
    }
    mode dock = dock {
        1: done            -> found
        2: held(lost, 5 s) -> explore
    }
    final mode found = halt
}
