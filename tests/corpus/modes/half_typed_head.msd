// The name of a mode that does not parse is not reported where it is used.
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> rest
    }
    mode rest requires { //~ error LM0101
        halt()
        1: after 1 s -> go
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect modes go, rest
    expect go -> rest
}
