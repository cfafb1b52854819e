// The one fault is in the other file: nothing that depends on it is reported here.
import bump
import std.robots.j5

behavior wander on j5 {
    sense bump(contact_force)

    flag pressed = bumped or contact_force > 300 N

    entry go

    mode go {
        drive(26 cm/s)
        1: bumped      -> rest
        2: bump.bumped -> rest
        3: pressed     -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect never bumped
    expect never bump.bumped
    expect never pressed
}
