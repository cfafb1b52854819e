// The speed is ours.
import std.interfaces.alert_base

/// Drives straight ahead until something is in the way.
behavior drive on alert_base {
    entry onward

    mode onward {
        drive(25 cm/s)
        1: blocked -> stopped
    }
    final mode stopped { halt() }
}
