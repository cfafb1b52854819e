import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    entry go

    mode go {
        drive(26 cm/s)
        1: forward_colision       -> rest //~ error LM0201
        2: obstacle_id.heavy      -> rest //~ error LM0201
        3: obstcle_id.heavy_obstacle -> rest //~ error LM0201
        4: a.b.c                  -> rest //~ error LM0201
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
