// Its events are not reported as unknown too.
import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    sense obstacle_ids(left_wheel_acceleration, right_wheel_acceleration, contact_force) //~ error LM0201

    flag stuck = heavy_obstacle and not forward_collision

    entry go

    mode go {
        drive(26 cm/s)
        1: stuck -> again
    }
}

scenario short_drive runs wander {
    duration 3 s
    expect never heavy_obstacle
}
