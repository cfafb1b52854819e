// The car-like robot of Khatoon and Ibraheem (2012, section 2): a range finder around it, and wheels that are steered.
//
// From the paper: the motion of eqs. 2 to 4, the limits of speed and steering, a world of 100 m by 100 m, and what the
// range finder yields. Mass, size, the length of a control cycle, the number of beams, the noise, how wide a side is, and
// how far an opening reaches are ours: the paper gives them nowhere.

/// A car: a range finder of 36 beams, and the directions and distances that follow from it. It keeps no `mobile_base`,
/// since it cannot turn in place.
robot car {
    body car_like {
        mass 500 kg
        size (2 m, 1 m)
        cycle 1 s
        speed_limit 2 m/s
        steering_limit 40 deg
    }

    /// The range finder, from just left of where it heads to the left around.
    sensor range[36]: m in 0 .. 100 fails 100 = ring.range noise 0.1 period 100 ms beam 10 deg
    sensor front_bumper: contact fails set = bumper.front
    sensor back_bumper: contact fails set = bumper.back
    /// Tgt-dir: where the goal is, to the left.
    sensor goal_bearing: deg in -180 .. 180 fails 0 = goal.bearing noise 1 period 100 ms
    sensor goal_distance: m in 0 .. 200 fails 200 = goal.distance noise 0.1 period 100 ms

    /// The temporary goal of the planner.
    optional sensor waypoint_bearing: deg in -180 .. 180 fails 0 = planner.bearing noise 1 period 100 ms
    optional sensor waypoint_distance: m in 0 .. 200 fails 200 = planner.distance noise 0.1 period 100 ms

    /// Gate-dir: where the widest open area ahead is, to the left.
    logical gate = widest(range[27..35, 0..8], beyond: 10 m)
    /// Obst-dist
    logical nearest = min(range)
    /// Min-l
    logical left = min(range[3..14])
    /// Min-r
    logical right = min(range[21..32])

    action plan() = planner.plan()
    action next_waypoint() = planner.next()
    action halt() = body.stop()
    action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    action arc(speed: m/s, radius: m) = body.arc(speed, radius)
    /// Drives with the wheels steered, to the left for a positive angle.
    action steer(speed: m/s, angle: deg) = body.steer(speed, angle)
}
