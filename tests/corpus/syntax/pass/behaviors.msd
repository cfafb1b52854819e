import std.robots.j5
import obstacle_id

/// Push what is light, go around what is heavy.
behavior obstacle_manipulation on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, force: contact_force)
    sense second = obstacle_id()

    /// Time to go home.
    flag low_battery = battery < 11 V
    flag odd = (low_battery or not rising(hit)) and held(hit, 200 ms) and latched(hit)
    flag sums = 2 * (front - 3 m) / back >= -front + - 4 m and a != b or c == 30 % and x <= 1
    flag close = front < 3 m and speed is any of {slow, medium} and gap is wide
    flag crossed = goal.bearing > 3 deg and goal and robot.speed > 1 m/s and goal < 3
    flag far_away = 5 km < front

    entry init

    mode init {
        halt()
        /// after a while
        1: after 2 s -> forward
    }
    /// Straight ahead.
    mode forward {
        on enter { beep() lamp.on(1) }
        on exit { }
        drive(26 cm/s)
        1: obstacle_id.heavy_obstacle    -> stop
        2: forward_collision and count(forward_collision) >= 3 -> push
        3: failed(sonar[3]) or explore.mode is stop -> again
    }
    mode push requires contact_force, sonar else stop {
        arc(26 cm/s, radius: 1 m)
        1: heavy_obstacle -> stop 2: after 4 s -> forward
    }
    mode random_turn {
        turn(random(-120 deg, 120 deg))
        1: done -> forward
    }
    final mode stop { halt() }
}

behavior collision_avoidance extends obstacle_manipulation on labmate {
    entry forward
    mode forward {
        decide (right, left, front - 1 m) {
            (close, close, close) => halt()
            (close, _,     {close, far}) => nothing
            (close, -,     _    ) => either(turn_left(10 deg), go_bkwd(0 inch))
        }
        1: state is backward -> again
    }
}

activity clear_area on j5 {
    entry explore
    mode explore = obstacle_avoidance    { 1: crate_seen -> clear }
    mode clear   = obstacle_manipulation resume requires contact_force else explore {
        1: failed(contact_force) -> explore   2: after 60 s -> explore
    }
    mode wait requires a = waiting resume
    mode rest = resting
}
goal tidy on j5 { entry a mode a = clear_area { } }
