// The manipulation experiment with the force sensor disconnected (Born & Wright 2007, section 4.1, eq. 10, fig. 13).
//
// A force of 0 leaves (neg, neg, low) as the only rule that can speak for a collision: the first one is still found,
// from acceleration alone. Nothing can be called heavy any more, so the robot keeps on pushing.

import manipulation

scenario force_faulted extends manipulation {
    fault contact_force = 0 N from 0 s

    expect forward -> push within 4.5 s .. 5.5 s
    expect never heavy_obstacle
    expect never stop
}

/// The same, but the robot knows: push is inhibited, and every collision is avoided instead.
scenario force_reported extends manipulation {
    fail contact_force from 0 s

    expect modes init, forward, stop, back_up
    expect forward -> stop within 4.5 s .. 5.5 s
    expect never push
}
