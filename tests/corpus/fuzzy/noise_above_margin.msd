import std.networks.preliminary_obstacle_id
import std.networks.obstacle_id

robot rover {
    sensor left: m/s^2 in -4 .. 4 fails 0 noise 0.6
    sensor right: m/s^2 in -4 .. 4 fails 0 noise 0.4
    sensor force: N in 0 .. 400 fails 0 noise 60
    sensor above: N in 10 .. 400 fails 10 noise 60
    action halt()
}

behavior watch on rover {
    sense preliminary_obstacle_id(left, right) //~ warning LM0525
    sense obstacle_id(right, right, force) //~ warning LM0525

    entry wait

    mode wait {
        halt()
        1: preliminary_obstacle_id.forward_collision or obstacle_id.forward_collision -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> wait
    }
}

// Nothing is known of its rest.
behavior look on rover {
    sense obstacle_id(left, right, above)

    entry wait

    mode wait {
        halt()
        1: forward_collision -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> wait
    }
}
