import std.robots.j5

behavior wander on j5 {
    entry forward

    mode forward {
        drive(26 cm/s)
        1: contact_force > 115 N -> turn_away
    }
    mode turn_away { //~ warning LM0415
        turn(random(-120 deg, 120 deg))
        1: done -> again
    }
}
