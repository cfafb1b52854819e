// What is not a column, a cell or a command; each is told of once.
import std.networks.obstacle_id

robot pusher {
    sensor left: m/s^2 in -4 .. 4 fails 0
    sensor right: m/s^2 in -4 .. 4 fails 0
    sensor strain[3]: N in 0 .. 400 fails 0
    sensor broken: parsec in 0 .. 1 //~ error LM0302
    sensor battery: V in 0 .. 14 fails 0
    sensor bumper: contact fails set
    action halt()
    action turn(angle: deg) -> done
}

behavior columns on pusher {
    sense obstacle_id(left, right, strain[0])

    flag right = bumper

    entry go

    mode go {
        turn(90 deg)
        decide (after 2 s) { //~ error LM0309
            (set) => halt()
        }
        1: done -> second
    }
    mode second {
        decide (rising(bumper), battery > 11 V, not bumper) { //~ error LM0309, error LM0309, error LM0309
            (_, _, _) => halt()
        }
        1: after 1 s -> third
    }
    mode third {
        decide (battery, strain, strain[3], forc) { //~ error LM0309, error LM0309, error LM0201, error LM0201
            (_, _, _, _) => halt()
        }
        1: after 1 s -> fourth
    }
    mode fourth {
        decide (left, obstacle_id.left, bumper, bumper) { //~ error LM0310, error LM0310
            (_, _, _, _) => halt()
        }
        1: after 1 s -> fifth
    }
    mode fifth {
        decide (right, broken) { //~ error LM0206
            (_, huge) => halt()
        }
        1: after 1 s -> sixth
    }
    mode sixth {
        decide (left, bumper, force) {
            (neg,  set)        => halt() //~ error LM0307
            (nag,  set,  _)    => halt() //~ error LM0201
            (zero, pos,  _)    => halt() //~ error LM0309
            (pos,  _,    low)  => stop() //~ error LM0201
            (pos,  _,    med)  => either(halt()) //~ error LM0307
            (pos,  _,    high) => left //~ error LM0309
        }
        decide (bumper) { //~ error LM0310
            (_) => nothing
        }
        1: after 1 s -> seventh
    }
    mode seventh {
        decide (left) {} //~ error LM0311
        1: after 1 s -> go
    }
}
