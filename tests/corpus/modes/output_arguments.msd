import std.networks.navigator
import std.networks.navigator_as_printed

robot cart {
    sensor goal_at: deg in -180 .. 180  fails 0
    sensor open_at: deg in -180 .. 180  fails 0
    sensor ahead: m in 0 .. 100  fails 0
    sensor beside: m in 0 .. 100  fails 0
    action go(speed: m/s)
    action steer(angle: deg)
    action stop()
}

behavior follow on cart {
    sense navigator(goal_at, open_at, ahead, beside, beside)
    sense printed = navigator_as_printed(goal_at, open_at, ahead, beside, beside)

    entry on_the_way

    mode on_the_way {
        on enter { go(navigator.speed) }
        steer(printed.steering)
        1: after 5 s -> wrong
    }
    mode wrong {
        stop()
        on enter { go(speed) } //~ error LM0206
        on enter { go(printed.steering) } //~ error LM0301
        on enter { go(printed.pace) } //~ error LM0201
        on enter { go(pace) } //~ error LM0201
        on exit { go(ahead) } //~ error LM0301
        1: after 5 s -> on_the_way
    }
}
