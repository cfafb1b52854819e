// All numbers are ours.
import std.interfaces.ranging_base

/// Drives to a wall, and along it on its right, into corners and around them.
behavior follow_wall on ranging_base {
    flag near   = ahead_right < 70 cm or right < 40 cm
    flag far    = ahead_right > 85 cm
    flag walled = front < 50 cm

    entry seek

    /// Straight ahead, until there is a wall.
    mode seek {
        drive(25 cm/s)
        1: blocked or walled or not far -> along
    }
    mode along {
        decide (near, far) {
            (set,   _    ) => arc(20 cm/s, radius: 1 m)
            (clear, set  ) => arc(20 cm/s, radius: -80 cm)
            (clear, clear) => drive(20 cm/s)
        }
        1: blocked or walled -> corner
    }
    /// To the left, again and again until there is room ahead.
    mode corner {
        turn(20 deg)
        1: done -> along
    }
}
