import std.interfaces.mobile_base

/// A base that moves, and tells when something is in its way.
interface alert_base extends mobile_base {
    /// Something is in the way ahead. How the robot knows is its own affair: by touch, by sight, or by its wheels.
    sensor blocked: contact fails clear
}
