interface mobile {
    action halt(
    action drive(speed)
    action arc(speed: m/s) -> dnoe
    sensor a m in 0 .. 4
    snsor b: m
}
robot r provides {
    sensor a: m
}
robot labmate provides mobile {
    body differential_drive { mass }
    sensor a: in 0 .. 4
    sensor b[24: m in 0 .. 4
    sensor c: m in 0 - 4
    sensor d: m in 0 .. 4 fails 0, , any
    sensor e: m in 0 .. 4 nosie 3
    sensor f: m/ in 0 .. 4
    sensor g: m in 0 .. 4 = wheel.
    logical h min(a)
    action halt() = body
    sensor sound: m in 0 .. 4
}
arbiter a on labmate {
    emergency front_bumper halt()
    client avoid = collision_avoidance
    client seek = goal_seeking priority
    client go priority 3
    ties
    client sound = wander priority 1
}
team t {
    robot a = j5
    robot b j5 runs x
    a.b = 
    a.c is d
    robot sound = j5 runs x
}
