/// One wheel, several drivers.
arbiter navigation on labmate {
    emergency front_bumper -> halt()          // bypasses the multiplexer
    emergency back_bumper and not stuck -> body.halt()
    /// keeps clear
    client avoid  = collision_avoidance priority 1 when state is forward else 3
    client seek   = goal_seeking        priority 5
    client wander = simple_navigation   priority 9 when won else 8 when x > 3 m else 10
    ties in_order
}
arbiter chance { ties random }

/// Two of a kind.
team pushers {
    robot a = j5 runs clear_area
    robot b = j5 runs clear_area
    a.partner_pushing = b.mode is clear       // one tick later
    b.partner_pushing = a.mode is clear and not a.command is halt
}
