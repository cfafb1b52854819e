// What extends it is not reported again.
import std.robots.j5

behavior wander on j5 { //~ error LM0401
    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

behavior hurry extends wander {
    mode go {
        drive(50 cm/s)
        1: after 5 s -> again
    }
}
