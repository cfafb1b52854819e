world w {
    wall (0 m, 0 m)
    wall (0 m, 0 m) -> (1 m)
    door at (8 m, 2 m) heading 0 deg
    box mass 30 kg size (0.4 m) at (1 m, 1 m)
    box mass 30 kg at (1 m, 1 m)
    gaol (11 m, 1 m)
    goal (11 m, 1 m)
}
scenario s runs a on b {
    duration ten s
    tick
    seed 1.5.2
    place rbot at (0 m, 0 m)
    place box mass 1 kg size (1 m, 1 m) at 3 m
    fault s from 0 s
    fail
    expect
    expect forward -> push within 4.5 s
    expect never heavy befor 3 s
    expext sound
    expect sound
}
property no_colon never a
property p: a leads b
property q: never
property sound: never a
