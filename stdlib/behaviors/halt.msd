import std.interfaces.mobile_base

/// Stands still.
behavior halt on mobile_base {
    entry still

    final mode still { halt() }
}
