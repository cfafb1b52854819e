// The manipulation experiment with both acceleration sensors disconnected (Born & Wright 2007, section 4.1, eqs. 11
// and 12).
//
// Accelerations of 0 leave (zero, zero, med) and (zero, zero, high) to speak for a collision and (zero, zero, low)
// against it: collisions are found from force alone, and the robot goes through the same modes as with all sensors.

import manipulation

scenario acceleration_faulted extends manipulation {
    fault left_wheel_acceleration  = 0 m/s^2 from 0 s
    fault right_wheel_acceleration = 0 m/s^2 from 0 s

    expect modes init, forward, push, stop, back_up
    expect forward -> push within 4.5 s .. 5.5 s
    expect push -> stop within 7.5 s .. 8.5 s
    expect never heavy_obstacle before 7.5 s
}
