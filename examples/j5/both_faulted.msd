// The manipulation experiment with force and both accelerations disconnected. The paper stops before this one.
//
// All readings at 0 leave only (zero, zero, low), which speaks against a collision: none is ever found, and the robot
// keeps pushing forward.

import manipulation

scenario both_faulted extends manipulation {
    fault contact_force            = 0 N     from 0 s
    fault left_wheel_acceleration  = 0 m/s^2 from 0 s
    fault right_wheel_acceleration = 0 m/s^2 from 0 s

    expect modes init, forward
    expect never forward_collision
    expect never heavy_obstacle
    expect always forward after 2 s
}
