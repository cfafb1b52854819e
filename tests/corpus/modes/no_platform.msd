behavior wander { //~ error LM0311
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

behavior hurry extends wander {
    entry go
}
