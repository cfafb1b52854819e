// The behavior's file imports the robot, but this one does not.
import std.behaviors.obstacle_manipulation

scenario short_drive runs obstacle_manipulation on j5 { //~ error LM0201
    duration 3 s
}
