// A box of the world cannot stand there twice.
import std.behaviors.obstacle_avoidance
import std.robots.j5

world hallway {
    box crate mass 30 kg size (0.4 m, 0.6 m) at (3 m, 0 m)
}

scenario short_drive runs obstacle_avoidance on j5 in hallway {
    duration 3 s
    place box crate mass 90 kg size (0.4 m, 0.6 m) at (5 m, 0 m) //~ error LM0202
}
