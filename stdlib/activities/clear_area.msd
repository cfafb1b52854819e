// All times are ours.
import std.behaviors.halt
import std.behaviors.obstacle_avoidance
import std.behaviors.push
import std.interfaces.pushing_base

/// Pushes out of the way what can be pushed, here and there, and rests when it has found nothing for three minutes.
activity clear_area on pushing_base {
    flag pushing = held(sweep.mode is push, 5 s)

    entry sweep

    mode sweep = push {
        1: held(not pushing, 3 min)               -> rest
        2: after 1 min and not sweep.mode is push -> move_on
    }
    mode move_on = obstacle_avoidance {
        1: after 20 s -> sweep
    }
    final mode rest = halt
}
