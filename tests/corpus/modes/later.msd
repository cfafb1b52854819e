// What this version reads and does not run: one finding each, nothing about what uses it.
import std.behaviors.obstacle_avoidance
import std.robots.j5

behavior odd on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: other.mode is go           -> wait //~ error LM0201
        2: contact_force - 3 N > 10 N -> wait //~ error LM0105
    }
    mode wait {
        drive(steering) //~ error LM0201
        1: after 5 s -> go
    }
}

team pushers { //~ error LM0105
    robot a = j5 runs odd
}
