import std.behaviors.obstacle_avoidance
import std.robots.j5

world hallway {
    wall (3 m, -2 m) -> (3 m, 2 m)
}

scenario box_in_the_robot runs obstacle_avoidance on j5 {
    duration 3 s
    place box mass 30 kg size (0.4 m, 0.6 m) at (0.3 m, 0 m) //~ error LM0801
}

scenario box_in_a_box runs obstacle_avoidance on j5 {
    duration 3 s
    place box light mass 30 kg size (0.4 m, 0.6 m) at (2 m, 0 m)
    place box heavy mass 90 kg size (0.4 m, 0.6 m) at (2.1 m, 0.1 m) //~ error LM0801
}

scenario box_in_a_wall runs obstacle_avoidance on j5 in hallway {
    duration 3 s
    place box mass 30 kg size (0.4 m, 0.6 m) at (3.1 m, 0 m) //~ error LM0801
}

scenario robot_in_a_wall runs obstacle_avoidance on j5 in hallway { //~ error LM0801
    duration 3 s
    place robot at (3 m, 0 m) heading 90 deg
}
