// All times are ours.
import std.behaviors.dock
import std.behaviors.follow_wall
import std.behaviors.halt
import std.behaviors.seek_goal
import std.interfaces.located_base

/// Drives to its goal and docks there; where that takes too long, it goes a way along the walls and tries again.
activity return_home on located_base {
    entry home

    mode home = seek_goal {
        1: done        -> dock
        2: after 1 min -> along
    }
    /// Out of what it would have to leave backward.
    mode along = follow_wall {
        1: after 40 s -> home
    }
    mode dock = dock {
        1: done        -> rest
        2: after 1 min -> home
    }
    final mode rest = halt
}
