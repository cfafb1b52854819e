// A robot senses through a network that none of its logical sensors looks at.
import std.networks.obstacle_id

robot pusher {
    sensor left: m/s^2 in -4 .. 4 fails 0
    sensor right: m/s^2 in -4 .. 4 fails 0
    sensor force: N in 0 .. 400 fails 0
    sense obstacle_id(left, right, force)
    sense mirrored = obstacle_id(right, left, force) //~ warning LM0209
    logical blocked = obstacle_id.forward_collision
    action halt()
}

behavior wait on pusher {
    entry rest

    mode rest {
        halt()
        1: rising(blocked) -> again
    }
}
