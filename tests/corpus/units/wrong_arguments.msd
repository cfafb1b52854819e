import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration) //~ error LM0307

    flag pressed = contact_force > 115 N

    entry go

    mode go {
        arc(26 cm/s) //~ error LM0307
        1: forward_collision     -> rest
        2: held(pressed)         -> rest //~ error LM0307
        3: rising()              -> rest //~ error LM0307
        4: failed(pressed)       -> rest //~ error LM0204
        5: failed(after 2 s)     -> rest //~ error LM0307
        6: held(pressed, pressed) -> rest //~ error LM0307
    }
    mode rest {
        halt(0 m/s) //~ error LM0307
        turn(random(90 deg)) //~ error LM0307
        1: after 1 s -> go
    }
}

robot rover {
    body differential_drive { mass 20 kg  size 0.5 m  track (0.35 m, 1 m)  traction 0.6 } //~ error LM0307, error LM0307
    action drive(speed: m/s) = body.velocity(speed) //~ error LM0307
}
