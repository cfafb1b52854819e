// A robot of ours, of no paper: small, with range sensors all around, bumpers, a plate in front that feels what it pushes,
// and a beacon receiver, so that everything the library is written on runs on it.

import std.interfaces.located_base
import std.interfaces.pushing_base

/// A small robot of ours: 16 range sensors around it, a bumper, a force-sensing plate, and a receiver for a beacon.
robot scout provides located_base, pushing_base {
    body differential_drive {
        mass 20 kg
        size (0.5 m, 0.4 m)
        track 0.35 m
        traction 0.6
    }

    /// The ring, from just left of where it heads to the left around.
    sensor range[16]: m in 5 cm .. 6 m fails 6 m = ring.range accuracy 1 cm period 40 ms beam 10 deg
    sensor bumper: contact fails set = bumper.front
    sensor force: N in 0 .. 200 fails 200 = wedge.force noise 1
    optional sensor goal_distance: m in 0 .. 1000 fails 1000 = goal.distance
    optional sensor goal_bearing: deg in -180 .. 180 fails 0 = goal.bearing
    /// For scenarios: no behavior of the library looks at them.
    optional sensor x: m in -1000 .. 1000 fails 0 = pose.x
    optional sensor y: m in -1000 .. 1000 fails 0 = pose.y

    logical front = min(range[14..15, 0..1])
    logical ahead_left = min(range[1..2])
    logical ahead_right = min(range[13..14])
    logical left = min(range[3..4])
    logical right = min(range[11..12])
    logical blocked = bumper or front < 25 cm
    logical overloaded = force > 60 N

    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action arc(speed: m/s, radius: m) = body.arc(speed, radius)
    action turn(angle: deg) -> done = body.rotate(angle)
}
