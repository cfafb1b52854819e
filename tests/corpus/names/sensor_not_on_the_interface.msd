// `j5` has a force sensor, but the interface says nothing of one.
import std.interfaces.mobile_base
import std.robots.j5

behavior wander on mobile_base {
    entry go

    mode go {
        drive(26 cm/s)
        1: contact_force > 100 N -> again //~ error LM0201
    }
}
