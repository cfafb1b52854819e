// Where the behaviors of the library are tried. All measures are ours.

/// A room with a table in it.
world furnished {
    wall (0 m, 0 m) -> (10 m, 0 m) -> (10 m, 8 m) -> (0 m, 8 m) -> (0 m, 0 m)
    wall (4 m, 3 m) -> (6.5 m, 3 m) -> (6.5 m, 5 m) -> (4 m, 5 m) -> (4 m, 3 m)
    box mass 300 kg size (0.5 m, 0.5 m) at (8.3 m, 6.3 m) heading 20 deg
    goal (8.2 m, 3.6 m)
}

/// A room with nothing in it.
world bare {
    wall (0 m, 0 m) -> (8 m, 0 m) -> (8 m, 6 m) -> (0 m, 6 m) -> (0 m, 0 m)
    goal (6 m, 4 m)
}

/// A room around a corner.
world angled {
    wall (0 m, 0 m) -> (9 m, 0 m) -> (9 m, 7 m) -> (5 m, 7 m) -> (5 m, 4 m) -> (0 m, 4 m) -> (0 m, 0 m)
}

/// A corridor with two bends.
world corridor {
    wall (0 m, 0 m) -> (8 m, 0 m) -> (12 m, 1.5 m) -> (18 m, 1.5 m) -> (18 m, 3.9 m) -> (12 m, 3.9 m)
        -> (8 m, 2.4 m) -> (0 m, 2.4 m) -> (0 m, 0 m)
}

/// A room with a pocket in the way to the goal.
world pocket {
    wall (0 m, 0 m) -> (10 m, 0 m) -> (10 m, 8 m) -> (0 m, 8 m) -> (0 m, 0 m)
    wall (3.5 m, 2.2 m) -> (6.5 m, 2.2 m) -> (6.5 m, 5.8 m) -> (3.5 m, 5.8 m)
    goal (7.5 m, 4 m)
}
