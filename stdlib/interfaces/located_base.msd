import std.interfaces.ranging_base

/// A base that sees around it, and knows where its goal is.
interface located_base extends ranging_base {
    /// How far the goal is.
    optional sensor goal_distance: m in 0 .. 1000 fails 1000
    /// Where the goal is from where it heads, to the left.
    optional sensor goal_bearing: deg in -180 .. 180 fails 0
}
