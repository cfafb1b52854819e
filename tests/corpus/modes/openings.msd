// An opening lies among neighboring beams of one ring.
robot ring {
    sensor range[12]: m in 0 .. 10 fails 10 = ring.range
    sensor near[12]: m in 0 .. 1 fails 1 = ring.range
    sensor plain[4]: m in 0 .. 10 fails 10
    sensor heading: deg in -180 .. 180 fails 0 = pose.heading

    logical ahead = widest(range[9..11, 0..2], beyond: 3 m)
    logical around = widest(range[6..11, 0..5], beyond: 3 m)
    logical shuffled = widest(range[0..2, 5], beyond: 3 m) //~ error LM0309
    logical mixed = widest(range[0..2], near[3..5], beyond: 3 m) //~ error LM0309
    logical unknown = widest(plain, beyond: 3 m) //~ error LM0309
    logical one = widest(heading, beyond: 3 m) //~ error LM0309
    logical unsaid = widest(range) //~ error LM0311
    logical wrong = widest(range, beyond: 3 kg) //~ error LM0301
    logical named = widest(range, open: 3 m, beyond: 3 m) //~ error LM0309
    logical empty = widest(beyond: 3 m) //~ error LM0311
    logical deeper = widest(ahead, beyond: 3 m) //~ error LM0309

    action halt()
}
