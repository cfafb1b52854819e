// A property that holds, for a reason that lies in the past.
import std.robots.j5

behavior knock on j5 {
    flag touched = contact_force > 20 N

    entry wait

    mode wait {
        halt()
        1: count(touched) >= 3 -> go
    }
    mode go {
        drive(10 cm/s)
        1: after 2 s -> wait
    }
}

property asked: never rising(go) and not touched //~ info LM0805
property counted: touched leads to go within 10 s //~ error LM0804
