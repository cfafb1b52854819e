// The time is ours.
import std.behaviors.halt
import std.behaviors.push
import std.interfaces.pushing_base

/// Pushes what can be pushed, here and there, and rests when it has found nothing for three minutes.
activity clear_area on pushing_base {
    flag pushing = held(sweep.mode is push, 5 s)

    entry sweep

    mode sweep = push {
        1: held(not pushing, 3 min) -> rest
    }
    final mode rest = halt
}
