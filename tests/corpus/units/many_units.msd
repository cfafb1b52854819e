import std.robots.j5

behavior wander on j5 {
    flag pressed = contact_force > 0.115 kN and contact_force < 250000 mN
    flag same    = contact_force > 100 kg*m/s^2
    flag hard    = left_wheel_acceleration < -100 cm/s^2 or right_wheel_acceleration < -1 N/kg

    entry go

    mode go {
        drive(936 m/h)
        1: pressed        -> circle
        2: after 5000 ms and hard -> circle
        3: after 1 min    -> circle
        4: hard or same   -> circle
    }
    mode circle {
        arc(0.6 mm/ms, radius: 40 inch)
        1: after 3e6 us -> turn_away
    }
    mode turn_away {
        turn(random(-0.25 turn, 1570 mrad))
        1: done -> go
    }
}
