// A file as it looks while someone is typing in it: one fault, one finding.
import std.robots.j5

behavior wander on j5 {
    flag bumped = contact_force > 115 N
    flag tired  = contact_force > //~ error LM0101

    entry go

    mode go {
        drive(26 cm/s)
        1: bumped -> back_up
        2: tired  -> rest
        3: //~ error LM0101
    }
    mode back_up {
        drive(-20 cm/s //~ error LM0101
        1: after 1 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect never tired
    expect modes go, back_up
}
