// The behavior's file imports the robot, but this one does not.
import std.behaviors.obstacle_avoidance

scenario short_drive runs obstacle_avoidance on j5 { //~ error LM0201
    duration 3 s
}
