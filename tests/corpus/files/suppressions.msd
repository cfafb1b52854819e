// lmsl: allow-file(requires-without-else) because the bench has no second way
import std.robots.j5

behavior drive_once on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> parked
        2: contact_force > 9 N -> feel
    }
    mode feel requires contact_force {
        halt()
        1: after 1 s -> go
    }
    // lmsl: allow(dead-end) because someone carries the robot back
    /// Where it ends.
    mode parked {
        halt()
    }
    mode lost { // lmsl: allow(LM0404) because it is for the day there is a map
        halt()
        1: after 1 s -> go // lmsl: allow(dead-end) because nothing //~ warning LM0010
    }
    // lmsl: allow(dead-end) //~ warning LM0009
    // lmsl: allow(dead-end) because //~ warning LM0009
    // lmsl: allow(deadend) because of a typing error //~ warning LM0009
    // lmsl: allow(unknown-name) because it is known to me //~ warning LM0009
    // lmsl: allow-file(dead-end) because it stands too low //~ warning LM0009
    // lmsl: deny(dead-end) because it says so //~ warning LM0009
    // lmsl: allow(unreachable-mode) because a blank line is between //~ warning LM0010

    mode stuck { //~ warning LM0404, warning LM0406
        halt()
    }
}
