// What this version reads and does not run: one finding each, nothing about what uses it.
import std.behaviors.obstacle_avoidance
import std.robots.j5

robot labmate {
    body differential_drive { mass 50 kg  size (0.8 m, 0.7 m)  track 0.6 m  traction 0.5 }
    sensor sonar[24]: m in 15 cm .. 10 m  fails 10 m //~ error LM0105
    logical front = min(sonar[21, 22, 23, 0, 1, 2]) //~ error LM0105
    sensor bumper: contact  fails set //~ error LM0105
    action stop() = body.stop()
}

behavior stop_early on labmate {
    entry go

    mode go {
        stop()
        1: front < 1 m     -> again
        2: bumper          -> again
        3: failed(sonar)   -> again
    }
}

behavior odd on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: contact_force is high             -> table //~ error LM0105
        2: contact_force - 3 N > 10 N        -> table //~ error LM0105
    }
    mode table {
        decide (contact_force) { //~ error LM0105
            (high) => halt()
            (low)  => nothing
        }
        drive(steering) //~ error LM0201
        1: after 5 s -> go
    }
}

activity tidy on j5 { //~ error LM0105
    entry work

    mode work = obstacle_avoidance {
        1: after 5 s -> again
    }
}

goal keep_tidy on j5 { //~ error LM0105
    entry work

    mode work = tidy {
        1: after 5 s -> again
    }
}

arbiter navigation on j5 { //~ error LM0105
    client avoid = obstacle_avoidance priority 1
}

team pushers { //~ error LM0105
    robot a = j5 runs tidy
}

world office {
    door at (8 m, 0 m) width 0.9 m heading 0 deg open //~ error LM0105
}

scenario tidy_up runs tidy on j5 {
    duration 3 s
}
