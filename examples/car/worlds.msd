// Worlds after figs. 7.1 to 7.7 of Khatoon and Ibraheem 2012, of 100 m by 100 m. The figures are lost; patterns and goals
// are as their titles say, and all measures are ours.

/// Two obstacles, the goal at the right (fig. 7.1).
world two_obstacles_right {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (41 m, 30 m) -> (59 m, 30 m) -> (59 m, 38 m) -> (41 m, 38 m) -> (41 m, 30 m)
    wall (34 m, 58 m) -> (66 m, 58 m) -> (66 m, 66 m) -> (34 m, 66 m) -> (34 m, 58 m)
    goal (70 m, 88 m)
}

/// The same, the goal at the left (fig. 7.2).
world two_obstacles_left {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (41 m, 30 m) -> (59 m, 30 m) -> (59 m, 38 m) -> (41 m, 38 m) -> (41 m, 30 m)
    wall (34 m, 58 m) -> (66 m, 58 m) -> (66 m, 66 m) -> (34 m, 66 m) -> (34 m, 58 m)
    goal (30 m, 88 m)
}

/// A corridor of 10 m, the goal at the left of its end (fig. 7.3).
world narrow_corridor_left {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (36 m, 18 m) -> (45 m, 18 m) -> (45 m, 60 m) -> (36 m, 60 m) -> (36 m, 18 m)
    wall (55 m, 18 m) -> (64 m, 18 m) -> (64 m, 60 m) -> (55 m, 60 m) -> (55 m, 18 m)
    goal (25 m, 88 m)
}

/// The same, the goal at the right (fig. 7.4).
world narrow_corridor_right {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (36 m, 18 m) -> (45 m, 18 m) -> (45 m, 60 m) -> (36 m, 60 m) -> (36 m, 18 m)
    wall (55 m, 18 m) -> (64 m, 18 m) -> (64 m, 60 m) -> (55 m, 60 m) -> (55 m, 18 m)
    goal (75 m, 88 m)
}

/// Seven obstacles, the goal at the right (fig. 7.5).
world many_obstacles_right {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (44 m, 26 m) -> (54 m, 26 m) -> (54 m, 34 m) -> (44 m, 34 m) -> (44 m, 26 m)
    wall (18 m, 34 m) -> (28 m, 34 m) -> (28 m, 42 m) -> (18 m, 42 m) -> (18 m, 34 m)
    wall (72 m, 30 m) -> (82 m, 30 m) -> (82 m, 38 m) -> (72 m, 38 m) -> (72 m, 30 m)
    wall (32 m, 54 m) -> (42 m, 54 m) -> (42 m, 62 m) -> (32 m, 62 m) -> (32 m, 54 m)
    wall (60 m, 52 m) -> (70 m, 52 m) -> (70 m, 60 m) -> (60 m, 60 m) -> (60 m, 52 m)
    wall (46 m, 72 m) -> (56 m, 72 m) -> (56 m, 80 m) -> (46 m, 80 m) -> (46 m, 72 m)
    wall (78 m, 66 m) -> (88 m, 66 m) -> (88 m, 72 m) -> (78 m, 72 m) -> (78 m, 66 m)
    goal (80 m, 88 m)
}

/// The same, the goal in the middle (fig. 7.6).
world many_obstacles_center {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (44 m, 26 m) -> (54 m, 26 m) -> (54 m, 34 m) -> (44 m, 34 m) -> (44 m, 26 m)
    wall (18 m, 34 m) -> (28 m, 34 m) -> (28 m, 42 m) -> (18 m, 42 m) -> (18 m, 34 m)
    wall (72 m, 30 m) -> (82 m, 30 m) -> (82 m, 38 m) -> (72 m, 38 m) -> (72 m, 30 m)
    wall (32 m, 54 m) -> (42 m, 54 m) -> (42 m, 62 m) -> (32 m, 62 m) -> (32 m, 54 m)
    wall (60 m, 52 m) -> (70 m, 52 m) -> (70 m, 60 m) -> (60 m, 60 m) -> (60 m, 52 m)
    wall (46 m, 72 m) -> (56 m, 72 m) -> (56 m, 80 m) -> (46 m, 80 m) -> (46 m, 72 m)
    wall (78 m, 66 m) -> (88 m, 66 m) -> (88 m, 72 m) -> (78 m, 72 m) -> (78 m, 66 m)
    goal (50 m, 90 m)
}

/// A corridor that is shut at its end, and the goal beyond (fig. 7.7).
world blocked_corridor {
    wall (0 m, 0 m) -> (100 m, 0 m) -> (100 m, 100 m) -> (0 m, 100 m) -> (0 m, 0 m)
    wall (38 m, 30 m) -> (38 m, 65 m) -> (62 m, 65 m) -> (62 m, 30 m)
    goal (50 m, 85 m)
}
