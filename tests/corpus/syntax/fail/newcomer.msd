behavior newcomer on j5 {
    entry init;
    flag a = b = 3 m
    flag c = d && e
    flag f = g || h
    flag i = !j
    flag k = (l and m
    flag n = o < p < q
    flag r = s + not t
    flag u = v is w + 1
    flag x = 3 m < y z
    mdoe init { halt() }
    mode one {
        halt();
        1 hit -> two
        2: hit two
        3: hit -> 
        4: hit = true -> two
        5: -> two
        hit -> two
        drive(26 cm/s,)
        drive 26 cm/s
        nothing
    }
    mode three
    mode event { }
    mode four { 1: mode -> four 2: hit -> rule }
    fnal mode five { }
    mode six { halt() ) }
    mode seven = { }
    mode eight = a = b { }
    mode nine { on entry { halt() } }
    mode ten { on enter { halt } on exit { halt() } }
    mode eleven { decide (a, b) { (x, y) -> halt() (x, y => halt()
        (x, z) => halt() } }
    mode twelve { 1: x is any of { } -> a }
}
behaviour british on j5 { entry a }
actvity near_miss on j5 { entry a }
goal sound on j5 { entry a }
world on { }
