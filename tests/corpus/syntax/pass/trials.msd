/// A hallway with a corner.
world hallway {
    wall (0 m, 0 m) -> (12 m, 0 m)
    wall (0 m, 2 m) -> (5 m, 2 m) -> (5 m, 4 m)
    door at (8 m, 2 m) width 0.9 m heading 0 deg open
    door at (9, 2) width 0.9
    box mass 30 kg size (0.4 m, 0.6 m) at (3 m, 1 m)
    box crate mass 30 size (0.4, 0.6) at (3, 1) heading 45 deg
    box mass mass 1 kg size (1 m, 1 m) at 2 ahead
    goal (11 m, 1 m)
}

/// Light first, then heavy.
scenario two_obstacles runs obstacle_manipulation on j5 in hallway {
    duration 10 s   tick 10 ms   seed 1
    place robot at (0 m, 0 m) heading 0 deg
    place robot a at 1 m ahead
    place box mass 30 kg size (0.4 m, 0.6 m) at 0.75 m ahead
    place box heavy mass 90 kg size (0.4 m, 0.6 m) at 1.5 ahead
    expect modes init, forward, push, stop, back_up
    expect forward -> push within 4.5 s .. 5.5 s
    expect forward -> push
    expect never heavy_obstacle before 7.5 s
    expect never heavy_obstacle
    expect always moving after 1 s
    expect always moving within 1 s .. 2
    expect never (failed(a) or after 3 s) after 5 s
    expect forward_collision within 4 s .. 6 s
    expect forward_collision and x > 3 within 4 .. 6
    expect heavy_obstacle
}
scenario bare { duration 10 tick 10 ms }
scenario force_faulted extends two_obstacles {
    fault contact_force = 0 N from 0 s to 3 s
    fault sonar[3] = any from 1
    fault a.sonar[0..3, 5] = absent
    fault front_bumper = set to 5 s
    fail contact_force from 1 s to 2 s
    fail sonar[3, 4]
}
/// Never blind.
property no_blind_push: never push and failed(contact_force)
property alive: always not stuck
property hurry of avoid: heavy_obstacle leads to stop within 500 ms
property patience: x > 3 leads to done
