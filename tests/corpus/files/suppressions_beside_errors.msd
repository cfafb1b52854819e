import std.networks.obstacle_id
import std.robots.j5

behavior drive_once on j5 {
    entry go

    // lmsl: allow(dead-end) because what is broken may be what this is for
    mode go {
        drive(26 cm/s)
        1: after 5 s -> home //~ error LM0201
    }
}
