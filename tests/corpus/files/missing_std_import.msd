// The robot is not reported as unknown too.
import std.robots.j6 //~ error LM0003

behavior wander on j6 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}
