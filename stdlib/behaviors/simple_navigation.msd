import std.robots.labmate

/// Always onward (Sobh et al. 2000, experiment 1).
behavior simple_navigation on labmate {
    entry onward

    final mode onward { go_frwd(0 inch) }
}
