behavior wander on j5 { //~ error LM0201
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> again
    }
}

behavior look on mobile_base { //~ error LM0201
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        halt()
        1: forward_collision -> again
    }
}
