// One circle is one finding, and what extends a member of it is not reported.
import std.robots.j5

behavior wander extends hurry { //~ error LM0205
    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

behavior hurry extends dash {
    mode go {
        drive(50 cm/s)
        1: after 5 s -> again
    }
}

behavior dash on j5 extends wander {
    entry go
}

behavior stroll extends wander {
    entry go
}

scenario short_drive runs stroll {
    duration 3 s
}
