// UALR's J5 (Born & Wright 2007, section 3 and fig. 5).
//
// From the paper: mass, size, the differential drive, the encoders and the wedge with its strain gauge. The sensors'
// ranges and noise, the track, the traction and the lag are ours: the paper shows them only in figures, or not at all.
// With a traction of 0.4 for wheels and boxes alike, the wheels slip from about 60 kg on, as in fig. 8.

import std.interfaces.pushing_base
import std.networks.obstacle_id

/// UALR's J5: 59 kg, 1 m long, 0.75 m wide, differential drive, force-sensing wedge.
robot j5 provides pushing_base {
    body differential_drive {
        mass 59 kg
        size (1 m, 0.75 m)
        track 0.65 m
        traction 0.4
        lag 0.15 s
        acceleration_limit 2 m/s^2
        impact_time 0.05 s
        tracking_noise 0.2 m/s^2
    }

    /// From the left encoder.
    sensor left_wheel_acceleration: m/s^2 in -4 .. 4 fails 0 = wheel.left.acceleration noise 0.05
    /// From the right encoder.
    sensor right_wheel_acceleration: m/s^2 in -4 .. 4 fails 0 = wheel.right.acceleration noise 0.05
    /// From the strain gauge behind the wedge.
    optional sensor contact_force: N in 0 .. 400 fails 0 = wedge.force noise 2

    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)

    /// It has run into something, as accelerations and force tell together.
    logical blocked = forward_collision
    logical overloaded = heavy_obstacle

    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action arc(speed: m/s, radius: m) = body.arc(speed, radius)
    action turn(angle: deg) -> done = body.rotate(angle)
}
