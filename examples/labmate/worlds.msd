// Worlds after figs. 10 to 13 of Sobh et al. 2000. The figures show no measures; these are ours.

/// A lab: tables and chairs in a room of 10 m by 8 m.
world lab {
    wall (0 m, 0 m) -> (10 m, 0 m) -> (10 m, 8 m) -> (0 m, 8 m) -> (0 m, 0 m)
    // A table against the upper wall, and one in the middle.
    wall (3 m, 8 m) -> (3 m, 6.6 m) -> (5.4 m, 6.6 m) -> (5.4 m, 8 m)
    wall (4.4 m, 3.4 m) -> (6.2 m, 3.4 m) -> (6.2 m, 4.4 m) -> (4.4 m, 4.4 m) -> (4.4 m, 3.4 m)
    // Chairs, too heavy to be pushed.
    box mass 500 kg size (0.5 m, 0.5 m) at (8.6 m, 6.4 m)
    box mass 500 kg size (0.5 m, 0.5 m) at (2 m, 2.2 m) heading 30 deg
    box mass 500 kg size (0.5 m, 0.5 m) at (8.4 m, 1.8 m) heading 15 deg
    goal (8.2 m, 4.6 m)
}

/// A hallway of 15 m by 4 m, and across it two walls as thick as a hand is long, each with an open door in both faces.
world hallway {
    wall (0 m, 0 m) -> (15 m, 0 m) -> (15 m, 4 m) -> (0 m, 4 m) -> (0 m, 0 m)
    wall (5 m, 0 m) -> (5 m, 4 m)
    wall (5.2 m, 0 m) -> (5.2 m, 4 m)
    door at (5 m, 1.5 m) width 1.8 m heading 90 deg open
    door at (5.2 m, 1.5 m) width 1.8 m heading 90 deg open
    wall (10 m, 0 m) -> (10 m, 4 m)
    wall (10.2 m, 0 m) -> (10.2 m, 4 m)
    door at (10 m, 2.5 m) width 1.8 m heading 90 deg open
    door at (10.2 m, 2.5 m) width 1.8 m heading 90 deg open
    // The jambs.
    wall (5 m, 0.6 m) -> (5.2 m, 0.6 m)
    wall (5 m, 2.4 m) -> (5.2 m, 2.4 m)
    wall (10 m, 1.6 m) -> (10.2 m, 1.6 m)
    wall (10 m, 3.4 m) -> (10.2 m, 3.4 m)
}
