import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        driv(26 cm/s) //~ error LM0201
        1: after 5 s -> rest
    }
    mode rest {
        stop() //~ error LM0201
        on enter { honk() } //~ error LM0201
        1: after 1 s -> go
    }
}
