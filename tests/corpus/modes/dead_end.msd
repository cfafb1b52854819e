import std.robots.j5

behavior drive_once on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> parked
    }
    mode parked { //~ warning LM0406
        halt()
    }
}
