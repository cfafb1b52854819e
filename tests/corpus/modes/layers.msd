// Diagrams inside each other that cannot be so, or that forestall each other.
import std.behaviors.obstacle_manipulation
import std.robots.j5

behavior wait on j5 {
    entry waiting

    mode waiting {
        1: after 30 s -> waited
    }
    final mode waited { }
}

activity tidy_up on j5 {
    entry tidy

    mode tidy = obstacle_manipulation { //~ warning LM0427
        1: failed(contact_force) -> rest
    }
    mode rest = wait { //~ warning LM0428
        1: done -> tidy
    }
}

activity over on j5 {
    entry first

    mode first = tidy_up { //~ error LM0426
        1: after 10 min -> second
    }
    mode second { //~ error LM0311
        1: after 1 min -> first
    }
    mode third = obstacle_manipulation resume {
        halt() //~ error LM0204
        1: third.mode is nowhere -> first //~ error LM0201
        2: second.mode is push   -> first //~ error LM0201
    }
}

behavior inverted on j5 {
    entry one

    mode one = wait { //~ error LM0204
        1: after 5 s -> again
    }
}

behavior of_another_layer on j5 extends tidy_up { } //~ error LM0204
