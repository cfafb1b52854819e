import std.networks.obstacle_id
import std.robots.j5

behavior caught on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry rest

    mode rest {
        halt()
        1: after 2 s -> forward
    }
    mode forward { //~ warning LM0604
        drive(26 cm/s)
        1: heavy_obstacle -> stop
        2: after 20 s     -> turn_away
    }
    mode turn_away {
        turn(random(-120 deg, 120 deg))
        1: done -> forward
    }
    mode stop { //~ info LM0607
        halt()
        1: after 1 s -> rest
    }
}

behavior astray on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry rest

    mode rest {
        halt()
        1: after 2 s -> forward
    }
    mode forward { //~ warning LM0605
        drive(26 cm/s)
        1: heavy_obstacle -> parked
        2: after 20 s     -> turn_away
    }
    mode turn_away {
        turn(random(-120 deg, 120 deg))
        1: done -> go_round
    }
    mode go_round {
        arc(26 cm/s, radius: 1 m)
        1: after 60 s -> turn_away
    }
    final mode parked { //~ info LM0607
        halt()
    }
}

// Known to have failed, the force inhibits the only way out.
behavior helpless on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry forward

    mode forward { //~ warning LM0604
        drive(26 cm/s)
        1: forward_collision -> push
    }
    mode push requires contact_force else forward {
        arc(26 cm/s, radius: 1 m)
        1: after 4 s -> forward
    }
}

// Whatever it misses, it starts over.
behavior restless on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry forward

    mode forward {
        drive(26 cm/s)
        1: heavy_obstacle -> stop
        2: after 20 s     -> turn_away
    }
    mode turn_away {
        turn(random(-120 deg, 120 deg))
        1: done -> forward
    }
    mode stop { //~ info LM0607
        halt()
        1: after 1 s -> forward
    }
}

// What is compared, or answered for, is known to whoever wrote it.
behavior aware on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry forward

    mode forward {
        drive(26 cm/s)
        1: heavy_obstacle        -> stop
        2: failed(contact_force) -> stop
    }
    mode stop {
        halt()
        1: contact_force < 10 N -> forward
    }
}
