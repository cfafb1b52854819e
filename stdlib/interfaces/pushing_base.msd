import std.interfaces.alert_base

/// A base that can push things, and tells when one is too heavy for it.
interface pushing_base extends alert_base {
    /// What it pushes is too heavy.
    sensor overloaded: contact fails set
}
