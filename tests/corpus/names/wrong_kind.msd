import std.behaviors.obstacle_avoidance
import std.networks.obstacle_id
import std.robots.j5

behavior wander on obstacle_id { //~ error LM0204
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

behavior hurry on j5 extends j5 { //~ error LM0204
    entry go
}

behavior feel on j5 {
    sense obstacle_avoidance(contact_force) //~ error LM0204

    entry go

    mode go {
        drive(26 cm/s)
        1: bumped -> again
    }
}

robot rover provides j5 { //~ error LM0204
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
}

scenario one runs j5 on j5 { //~ error LM0204
    duration 3 s
}

scenario two runs obstacle_avoidance on rover in j5 { //~ error LM0204, error LM0204
    duration 3 s
}

scenario three extends obstacle_avoidance { //~ error LM0204
    duration 3 s
}

behavior layered on j5 {
    entry go

    mode go = obstacle_avoidance { //~ error LM0204
        1: after 5 s -> again
    }
}
