// Khatoon and Ibraheem (2012, sections 3 and 4): the fuzzy navigator drives the car. How near the goal it stops is ours.

import std.networks.navigator
import std.robots.car

/// To the goal where nothing is near, to the open where something is.
behavior fuzzy_navigation on car {
    sense navigator(goal_bearing, gate, nearest, left, right)

    entry navigate

    mode navigate {
        steer(speed, steering)
        1: goal_distance < 1.5 m -> arrived
    }
    final mode arrived { halt() }
}
