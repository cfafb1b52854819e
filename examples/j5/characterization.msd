// Collision characterization (Born & Wright 2007, section 3.2, fig. 8): one box at a time, from 10 to 120 kg.
//
// The pushing force grows linearly with the mass until the wheels slip, at about 60 kg, and stays flat from there on.
// The spike of negative acceleration at the impact grows with every box, but not linearly. The bands are the
// model's values (mu m g up to mu M g; v m / (M + m) over the impact time) with room for sensor and tracking noise.

import std.robots.j5

/// Drives into whatever stands ahead and keeps pushing.
behavior ram on j5 {
    entry init

    mode init {
        halt()
        1: after 1 s -> ahead
    }
    final mode ahead {
        drive(26 cm/s)
    }
}

scenario mass_10 runs ram {
    duration 7 s  seed 1
    place box crate mass 10 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 30 N within 5 s .. 7 s
    expect always contact_force < 48 N within 5 s .. 7 s
    expect left_wheel_acceleration < -0.6 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -1.7 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_20 extends mass_10 {
    place box crate mass 20 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 69 N within 5 s .. 7 s
    expect always contact_force < 87 N within 5 s .. 7 s
    expect left_wheel_acceleration < -1.0 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -2.2 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_30 extends mass_10 {
    place box crate mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 109 N within 5 s .. 7 s
    expect always contact_force < 127 N within 5 s .. 7 s
    expect left_wheel_acceleration < -1.3 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -2.7 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_40 extends mass_10 {
    place box crate mass 40 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 148 N within 5 s .. 7 s
    expect always contact_force < 166 N within 5 s .. 7 s
    expect left_wheel_acceleration < -1.6 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -3.0 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_50 extends mass_10 {
    place box crate mass 50 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 187 N within 5 s .. 7 s
    expect always contact_force < 205 N within 5 s .. 7 s
    expect left_wheel_acceleration < -1.8 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -3.3 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_60 extends mass_10 {
    place box crate mass 60 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 222 N within 5 s .. 7 s
    expect always contact_force < 240 N within 5 s .. 7 s
    expect left_wheel_acceleration < -2.0 m/s^2 within 3.5 s .. 4.5 s
    expect never left_wheel_acceleration < -3.5 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_90 extends mass_10 {
    place box crate mass 90 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 222 N within 5 s .. 7 s
    expect always contact_force < 240 N within 5 s .. 7 s
    expect left_wheel_acceleration < -2.4 m/s^2 within 3.5 s .. 4.5 s
}

scenario mass_120 extends mass_10 {
    place box crate mass 120 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect always contact_force > 222 N within 5 s .. 7 s
    expect always contact_force < 240 N within 5 s .. 7 s
    expect left_wheel_acceleration < -2.6 m/s^2 within 3.5 s .. 4.5 s
}
