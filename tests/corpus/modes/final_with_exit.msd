import std.robots.j5

behavior drive_once on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> parked
    }
    final mode parked {
        halt()
        1: after 60 s -> go //~ error LM0407
    }
}
