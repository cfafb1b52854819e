// Khatoon and Ibraheem (2012, sections 3 and 4): the fuzzy navigator as it is printed drives the
// car: faster near obstacles, and straight on at 0 m/s where no rule fires. How near the
// goal it stops is ours.

import std.networks.navigator_as_printed
import std.robots.car

/// The same by the tables of the paper, not by its text.
behavior fuzzy_navigation_as_printed on car {
    sense navigator_as_printed(goal_bearing, gate, nearest, left, right)

    entry navigate

    mode navigate {
        steer(speed, steering)
        1: goal_distance < 1.5 m -> arrived
    }
    final mode arrived { halt() }
}
