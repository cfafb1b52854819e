import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact) //~ error LM0201

    flag pressed = contact_forse > 115 N //~ error LM0201

    entry go

    mode go {
        drive(26 cm/s)
        1: failed(wedge)     -> rest //~ error LM0201
        2: pressed           -> rest
        3: forward_collision -> rest
    }
    mode rest requires contact_froce else go { //~ error LM0201
        halt()
        1: after 1 s -> go
    }
}
