import base
import bump
import rover

behavior wander on base {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}

behavior careful extends wander on rover {
    sense bump(force)

    mode go {
        drive(10 cm/s)
        1: bumped    -> rest
        2: after 5 s -> rest
    }
}

scenario slow runs careful {
    duration 3 s
}

scenario fast runs wander on rover {
    duration 3 s
}
