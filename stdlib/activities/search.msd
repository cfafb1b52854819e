// All distances and times are ours.
import std.behaviors.dock
import std.behaviors.explore
import std.behaviors.halt
import std.behaviors.seek_goal
import std.interfaces.located_base

/// Explores until its goal is near, goes there and docks; explores on where that takes too long.
activity search on located_base {
    flag near = goal_distance < 2.5 m

    entry explore

    mode explore = explore {
        1: held(near, 500 ms) and after 20 s -> approach
    }
    mode approach = seek_goal {
        1: done        -> dock
        2: after 1 min -> explore
    }
    mode dock = dock {
        1: done        -> found
        2: after 1 min -> explore
    }
    final mode found = halt
}
