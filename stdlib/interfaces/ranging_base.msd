import std.interfaces.alert_base

/// A base that sees how far it is to what stands around it.
interface ranging_base extends alert_base {
    /// To the nearest thing ahead.
    sensor front: m in 0 .. 10 fails 10
    /// To the nearest thing half left of where it heads.
    sensor ahead_left: m in 0 .. 10 fails 10
    /// To the nearest thing half right of where it heads.
    sensor ahead_right: m in 0 .. 10 fails 10
    /// To the nearest thing on its left side.
    sensor left: m in 0 .. 10 fails 10
    /// To the nearest thing on its right side.
    sensor right: m in 0 .. 10 fails 10
}
