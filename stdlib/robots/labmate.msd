// LABMATE of the University of Utah (Sobh, Dekhil, Efros and Mihali 2000, section 4), a base of Transition Research
// Corporation.
//
// From the paper: 24 sonars in a ring, eight infrared sensors, two bumpers, the eight commands, and the states of
// fig. 6. Mass, size, track, speeds, and the numbers of the sensors are ours: the paper gives them nowhere.

import std.interfaces.located_base

/// LABMATE: 24 sonars around it, infrared sensors, bumpers, and commands that a machine of six states carries out.
robot labmate provides located_base runs labmate_drive {
    body differential_drive {
        mass 92 kg
        size (0.81 m, 0.75 m)
        track 0.66 m
        traction 0.5
        acceleration_limit 1 m/s^2
    }

    /// The ring of sonars, from just left of where it heads to the left around.
    sensor sonar[24]: m in 15 cm .. 10 m fails 10 m = ring.range accuracy 2.5 cm period 60 ms beam 15 deg
    /// The infrared sensors, in the same order.
    sensor infrared[8]: m in 5 cm .. 80 cm fails 80 cm = ring.range accuracy 1 cm period 20 ms
    sensor front_bumper: contact fails set = bumper.front
    sensor back_bumper: contact fails set = bumper.back
    /// GET-POSITION.
    optional sensor x: m in -1000 .. 1000 fails 0 = pose.x
    optional sensor y: m in -1000 .. 1000 fails 0 = pose.y
    optional sensor heading: deg in -180 .. 180 fails 0 = pose.heading
    /// Where the goal is, from the middle of the robot.
    optional sensor goal_distance: m in 0 .. 1000 fails 1000 = goal.distance
    optional sensor goal_bearing: deg in -180 .. 180 fails 0 = goal.bearing

    /// LS-FRWD
    logical front = min(sonar[21..23, 0..2])
    /// LS-LEFT
    logical left = min(sonar[3..8])
    /// LS-BKWD
    logical back = min(sonar[9..14])
    /// LS-RIGHT
    logical right = min(sonar[15..20])
    logical ahead_left = min(sonar[2..3])
    logical ahead_right = min(sonar[20..21])
    /// Where the way ahead is open, to the left of where it heads.
    logical opening = widest(sonar[18..23, 0..5], beyond: 3 m)
    logical blocked = front_bumper or front < 50 cm

    /// GO-FRWD: as far as that, or until told otherwise for 0.
    action go_frwd(distance: inch) -> done
    /// GO-BKWD
    action go_bkwd(distance: inch) -> done
    action turn_right(angle: deg) -> done
    action turn_left(angle: deg) -> done
    action stop()
    /// Out of FAULT.
    action reset()
    action read_sonar()
    action get_position()

    action halt() = stop()
    action drive(speed: m/s)
    action arc(speed: m/s, radius: m)
    action turn(angle: deg) -> done = turn_left(angle)

    /// What the machine of six states asks of the wheels.
    action brake() = body.stop()
    action advance(distance: inch) -> done = body.travel(distance, 30 cm/s)
    action retreat(distance: inch) -> done = body.travel(distance, -30 cm/s)
    action roll(speed: m/s) = body.velocity(speed, 0 deg/s)
    action bend(speed: m/s, radius: m) = body.arc(speed, radius)
    action spin_left(angle: deg) -> done = body.rotate(angle)
    action spin_right(angle: deg) -> done = body.rotate(-angle)
}

/// The states of LABMATE (fig. 6): through `idle` whenever the command changes, into `faulted` where it touches something.
behavior labmate_drive on labmate {
    flag by_speed = command is any of {drive, arc}
    flag forth    = command is go_frwd or by_speed and command.speed >= 0 m/s
    /// Driven back by its speed, it minds what is behind it, as those who drive it so do not.
    flag back_up = command is go_bkwd or by_speed and command.speed < 0 m/s and back > 25 cm
    /// What is allowed in every state, and changes none.
    flag looks    = command is any of {read_sonar, get_position}

    entry idle

    mode idle {
        brake()
        1: forth                 -> forward
        2: back_up               -> backward
        3: command is turn_right -> right
        4: command is turn_left  -> left
    }
    mode forward {
        decide (command is drive, command is arc) {
            (set,   _    ) => roll(command.speed)
            (clear, set  ) => bend(command.speed, command.radius)
            (clear, clear) => advance(command.distance)
        }
        1: front_bumper            -> faulted
        2: done                    -> idle
        3: not forth and not looks -> idle
    }
    mode backward {
        decide (command is drive, command is arc) {
            (set,   _    ) => roll(command.speed)
            (clear, set  ) => bend(command.speed, command.radius)
            (clear, clear) => retreat(command.distance)
        }
        1: back_bumper               -> faulted
        2: done                      -> idle
        3: not back_up and not looks -> idle
    }
    mode right {
        spin_right(command.angle)
        1: front_bumper or back_bumper             -> faulted
        2: done                                    -> idle
        3: not command is turn_right and not looks -> idle
    }
    mode left {
        spin_left(command.angle)
        1: front_bumper or back_bumper            -> faulted
        2: done                                   -> idle
        3: not command is turn_left and not looks -> idle
    }
    mode faulted {
        brake()
        1: command is reset -> idle
    }
}
