import std.networks.obstacle_id //~ warning LM0207
import std.behaviors.obstacle_avoidance
import std.robots.j5 //~ warning LM0207

behavior avoid_slowly extends obstacle_avoidance {
    mode init {
        halt()
        1: after 4 s -> forward
    }
}
