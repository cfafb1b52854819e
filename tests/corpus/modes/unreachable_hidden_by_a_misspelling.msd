// The misspelt target may be the way to `rest`.
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> rset //~ error LM0201
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
