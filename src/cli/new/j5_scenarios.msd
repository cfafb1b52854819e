// What NAME does when something stands in its way, with all sensors and without one of them.

import NAME

/// A box ahead is found, and avoided.
scenario box_ahead runs NAME {
    duration 15 s  tick 10 ms  seed 1
    place box mass 90 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect modes wait, forward, back_up, turn_away, forward
    expect forward -> back_up within 4.5 s .. 5.5 s
}

/// The same while the force sensor is disconnected and reads 0 N: the wheels still feel the impact.
scenario without_force extends box_ahead {
    fault contact_force = 0 N from 0 s

    expect forward -> back_up within 4.5 s .. 5.5 s
}
