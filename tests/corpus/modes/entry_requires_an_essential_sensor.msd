import std.robots.j5

behavior roll on j5 {
    entry go

    mode go requires left_wheel_acceleration else rest {
        drive(26 cm/s)
        1: after 4 s -> rest
    }
    final mode rest {
        halt()
    }
}
