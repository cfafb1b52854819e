// All times are ours.
import std.behaviors.explore
import std.behaviors.follow_wall
import std.behaviors.turn
import std.interfaces.ranging_base

/// Along the walls, a look around, across the middle, and on along the walls.
activity patrol_area on ranging_base {
    entry along

    mode along = follow_wall {
        1: after 3 min -> look
    }
    /// Four quarter turns.
    mode look = turn {
        1: count(look.mode is on_around) >= 4 and look.mode is look -> across
    }
    mode across = explore {
        1: after 1 min -> along
    }
}
