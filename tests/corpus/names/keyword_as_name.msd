import std.robots.j5

behavior wander on j5 {
    flag tired = after //~ error LM0103

    entry rule //~ error LM0103

    mode rule { //~ error LM0103
        drive(26 cm/s)
        1: tired -> again
    }
}
