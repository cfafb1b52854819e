// Speeds, times and angles are ours.
import std.interfaces.pushing_base

/// Pushes what is in the way, and leaves alone what is too heavy.
behavior push on pushing_base {
    entry approach

    mode approach {
        drive(20 cm/s)
        1: overloaded -> back_up
        2: blocked    -> push
    }
    mode push {
        drive(15 cm/s)
        1: overloaded -> back_up
        2: after 30 s -> back_up
    }
    mode back_up {
        drive(-15 cm/s)
        1: after 2 s -> turn_away
    }
    mode turn_away {
        turn(random(60 deg, 150 deg))
        1: done -> approach
    }
}
