// Arrays, contacts and logical sensors, and what is wrong with them.
import std.networks.obstacle_id

robot ring {
    sensor sonar[8]: m in 0.15 .. 10 fails 10 beam 15 deg period 60 ms accuracy 2.5 cm
    sensor angle[2]: deg in -90 .. 90 fails 0
    sensor broken: parsec in 0 .. 1 //~ error LM0302
    sensor bumper[4]: contact fails set, any
    logical front = min(sonar[6, 7, 0, 1])
    logical back = median(sonar[2..5])
    logical touched = any(bumper[0..1], bumper[3])
    logical held = all(bumper)
    logical silent = mean(broken)
    logical mixed = min(sonar, angle) //~ error LM0301
    logical twice = max(sonar[0..3, 3]) //~ error LM0309
    logical empty = min() //~ error LM0311
    logical of_contacts = min(bumper) //~ error LM0309
    logical of_quantities = any(sonar) //~ error LM0309
    logical of_groups = min(front, back) //~ error LM0309, error LM0309
    logical of_itself = max(of_itself) //~ error LM0309
    logical average = average(sonar) //~ error LM0201
    logical sum = sonar //~ error LM0309
    logical beyond = min(sonar[6..8]) //~ error LM0201
    logical backwards = min(sonar[6..2]) //~ error LM0309
    logical single = min(angle[0], front[1]) //~ error LM0309
    logical named = min(first: sonar[0]) //~ error LM0309
    logical number = min(3 m) //~ error LM0309
    logical bumper = any(bumper) //~ error LM0202
    sensor none[0]: m in 0 .. 1 fails 0 //~ error LM0309
    sensor many[1001]: m in 0 .. 1 fails 0 //~ error LM0309
    sensor wide: m in 0 .. 1 fails 0 beam 180 deg //~ error LM0309
    sensor noisy: contact fails set noise 1 //~ error LM0309
    sensor between: contact fails 1 //~ error LM0309
    action halt()
}

behavior watch on ring {
    entry go

    mode go requires sonar else stop {
        halt()
        1: front < 1 m and sonar[4] > 2 m                   -> stop
        2: sonar < 1 m                                      -> stop //~ error LM0309
        3: sonar[0..1] < 1 m                                -> stop //~ error LM0309
        4: back[0] < 1 m                                    -> stop //~ error LM0309
        5: touched and not held and bumper[2]               -> stop
        6: bumper > 0.5                                     -> stop //~ error LM0309
        7: failed(sonar[0..2]) or failed(front)             -> stop
        8: failed(sonar[8])                                 -> stop //~ error LM0201
        9: silent > 1 or mixed > 1 m or none[0] < 1 m       -> stop
        10: sonar                                           -> stop //~ error LM0309
        11: front                                           -> stop //~ error LM0306
    }
    mode stop requires touched, many else go {
        halt()
        1: after 1 s -> go
    }
}
