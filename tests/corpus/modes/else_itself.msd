// A mode that would move to itself when its sensor fails.
import std.robots.j5

behavior push on j5 {
    entry wait
    mode wait {
        halt()
        1: after 1 s -> go
    }
    mode go requires contact_force else go { //~ error LM0309
        drive(26 cm/s)
        1: after 1 s -> wait
    }
}
