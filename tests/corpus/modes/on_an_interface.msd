import std.interfaces.mobile_base
import std.robots.j5

behavior look_around on mobile_base {
    entry look

    mode look {
        halt()
        1: after 2 s -> next
    }
    mode next {
        turn(angle: 90 deg)
        1: done -> look
    }
}

scenario look runs look_around on j5 {
    duration 6 s
    expect modes look, next, look
}
