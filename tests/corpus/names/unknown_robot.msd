import std.robots.j5

behavior wander on j6 { //~ error LM0201
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
}
