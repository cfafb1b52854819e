// Obstacle avoidance (Born & Wright 2007, section 3.1 and fig. 6). The modes are the paper's, and so is the speed of
// 26 cm/s; the other speeds, times and angles are ours.

import std.interfaces.alert_base

/// Drives ahead; turns away from what is in the way (fig. 6).
behavior obstacle_avoidance on alert_base {
    entry init

    /// Waits for the sensors to settle.
    mode init {
        halt()
        1: after 2 s -> forward
    }
    mode forward {
        drive(26 cm/s)
        1: blocked -> stop
    }
    mode stop {
        halt()
        1: after 500 ms -> back_up
    }
    mode back_up {
        drive(-20 cm/s)
        1: after 1.5 s -> random_turn
    }
    mode random_turn {
        turn(random(-120 deg, 120 deg))
        1: done -> forward
    }
}
