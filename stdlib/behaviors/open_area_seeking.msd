// What Khatoon and Ibraheem (2012, section 5) compare their navigator with: the car is driven to the open alone, after Kato
// and Kamikawa (1989). It stops if it happens to come to the goal.

import std.networks.open_area
import std.robots.car

/// To the open, wherever that leads.
behavior open_area_seeking on car {
    sense open_area(gate, nearest)

    entry roam

    mode roam {
        steer(speed, steering)
        1: goal_distance < 1.5 m -> arrived
    }
    final mode arrived { halt() }
}
