// Doors that lie on no wall, or reach past its end.
import std.behaviors.obstacle_avoidance
import std.robots.j5

world office {
    wall (0 m, 0 m) -> (6 m, 0 m) -> (12 m, 0 m) -> (12 m, 8 m)
    wall (0 m, 3 m) -> (3 m, 6 m)
    door at (6 m, 0 m) width 90 cm heading 180 deg open
    door at (2 m, 0.5 mm) width 90 cm
    door at (11.55 m, 0 m) width 90 cm
    door at (1.5 m, 4.5 m) width 90 cm heading 45 deg open
    door at (12 m, 4 m) width 90 cm open //~ error LM0808
    door at (0 m, 0.1 m) width 90 cm //~ error LM0808
    door at (0.2 m, 0 m) width 90 cm //~ error LM0808
    door at (6.5 m, 0 m) width 90 cm open //~ error LM0808
    door at (12 m, 4 m) width 0 m //~ error LM0309
}

world field {
    door at (2 m, 2 m) width 90 cm heading 10 deg //~ error LM0808
}

scenario office_hours runs obstacle_avoidance on j5 in office {
    duration 3 s
    place robot at (5 m, 2 m) heading 0 deg
}
