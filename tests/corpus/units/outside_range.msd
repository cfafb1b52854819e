import std.robots.j5

behavior wander on j5 {
    flag crushed = contact_force > 500 N //~ warning LM0305
    flag pulled  = -1 N >= contact_force //~ warning LM0305

    entry go

    mode go {
        drive(26 cm/s)
        1: crushed or pulled -> again
        2: left_wheel_acceleration < -9.81 m/s^2 -> again //~ warning LM0305
    }
}
