// Obstacle manipulation (Born & Wright 2007, section 3.1 and fig. 7): obstacle avoidance, with the push mode and the
// heavy flag added. The arc's radius and the time of a push are ours.

import std.behaviors.obstacle_avoidance
import std.networks.obstacle_id
import std.robots.j5

/// Pushes what is light, goes around what is heavy (fig. 7).
behavior obstacle_manipulation on j5 extends obstacle_avoidance {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    // lmsl: allow(trapped-by-failure) because a force stuck at 0 N makes every box look light, and the robot goes on
    // pushing for four seconds at a time; known to have failed, it inhibits push, and the robot avoids every box
    mode forward {
        drive(26 cm/s)
        1: heavy_obstacle    -> stop
        2: forward_collision -> push
        // Taken only while push is inhibited: without its force sensor the robot avoids everything.
        3: forward_collision -> stop
    }
    /// Pushes along a forward arc.
    mode push requires contact_force else stop {
        arc(26 cm/s, radius: 1 m)
        1: heavy_obstacle -> stop
        2: after 4 s      -> forward
    }
}
