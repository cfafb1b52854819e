// The preliminary network (Born & Wright 2007, section 3.2, eq. 4), side by side with the one that replaced it.
//
// From accelerations alone it finds collisions, but it takes errors in velocity tracking for collisions too, and it
// has no way to tell masses apart. The network with force ignores what one wheel does as long as nothing is touched.

import std.networks.obstacle_id
import std.networks.preliminary_obstacle_id
import std.robots.j5

/// Drives ahead and watches both networks.
behavior watch on j5 {
    sense preliminary_obstacle_id(left_wheel_acceleration, right_wheel_acceleration)
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry init

    mode init {
        halt()
        1: after 2 s -> ahead
    }
    final mode ahead {
        drive(26 cm/s)
    }
}

/// An empty floor: every detection is false.
scenario empty_floor runs watch {
    duration 12 s  seed 1

    expect preliminary_obstacle_id.forward_collision within 2.5 s .. 12 s
    expect never obstacle_id.forward_collision
}

/// Light and heavy boxes are both found. Only the network with force tells them apart.
scenario light_box runs watch {
    duration 7 s  seed 1
    place box crate mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect preliminary_obstacle_id.forward_collision within 4.5 s .. 5.5 s
    expect obstacle_id.forward_collision within 4.5 s .. 5.5 s
    expect never heavy_obstacle
}

scenario heavy_box extends light_box {
    place box crate mass 90 kg size (0.4 m, 0.6 m) at 0.75 m ahead

    expect preliminary_obstacle_id.forward_collision within 4.5 s .. 5.5 s
    expect obstacle_id.forward_collision within 4.5 s .. 5.5 s
    expect heavy_obstacle within 4.5 s .. 5.5 s
}
