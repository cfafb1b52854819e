import std.behaviors.obstacle_avoidance
import std.robots.j5

/// A mode, a flag and the entry are replaced; everything else is taken over.
behavior quick on j5 extends obstacle_avoidance {
    flag pressed = contact_force > 100 N

    entry forward

    mode forward {
        drive(40 cm/s)
        1: blocked -> stop
        2: pressed           -> init
    }
}

behavior quicker extends quick {
    flag pressed = contact_force > 50 N

    mode forward {
        drive(60 cm/s)
        1: blocked or pressed -> stop
        2: after 60 s                   -> init
    }
}
