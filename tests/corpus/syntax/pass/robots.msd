/// What a behavior may ask of any base that moves.
interface mobile_base {
    /// Stands still.
    action halt()
    action drive(speed: m/s)
    action arc(speed: m/s, radius: m)
    action turn(angle: deg) -> done
    sensor battery: V in 0 .. 15
}
interface nothing_at_all {}
/// Feels as well.
interface feeling_base extends mobile_base { sensor blocked: contact fails clear }

/// Differential drive, force-sensing wedge.
robot j5 provides mobile_base, nothing_at_all {
    body differential_drive { mass 59 kg  size (1 m, 0.75 m)  track 0.65 m  traction 0.4 lag 0.15 s }
    /// on the left
    sensor left_wheel_acceleration:  m/s^2 in -4 .. 4  fails 0  = wheel.left.acceleration  noise 0.05
    optional sensor contact_force:   N in 0 .. 400     fails 0 N, 400 N, any, absent  = wedge.force  noise 2
    sensor voltage: V = battery.voltage period 10 ms accuracy 0.1 V
    sensor aim: deg = goal.bearing
    action halt() = body.velocity(0 m/s, 0 deg/s)
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action arc(speed: m/s, radius: m) = body.velocity(speed, speed / radius)
    optional action turn(angle: deg) -> done = body.rotate(angle)
}

robot labmate {
    body differential_drive { mass 30 size (0.8, 0.8) }
    sensor sonar[24]: m in 15 cm .. 10 m  fails 10 m  = ring.range  accuracy 2.5 cm  period 60 ms  beam 15 deg
    logical front = min(sonar[21, 22, 23, 0, 1, 2])
    logical ahead = sonar[0] within 200 ms
    /// all around
    logical around = max(sonar[0..11, 12 .. 23]) - 2 * -front
    sense close_by = clearances(around, front)
    /// Something is in the way.
    logical blocked = front_bumper or front < 45 cm and not failed(front) or close_by.hit
    sensor front_bumper: contact fails set
    sensor back_bumper: contact fails clear = bumper.back
    action go_frwd(distance: inch)
}
