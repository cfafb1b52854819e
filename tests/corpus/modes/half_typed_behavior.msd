// The scenario's behavior is there, only not readable.
import std.robots.j5

behavior wander onto j5 { //~ error LM0101
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
}
