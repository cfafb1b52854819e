// As above, with an event that does not parse.
import bump
import std.robots.j5

behavior wander on j5 {
    sense bump(contact_force)

    entry go

    mode go {
        drive(26 cm/s)
        1: bumped      -> rest
        2: bump.bumped -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect never bumped
}
