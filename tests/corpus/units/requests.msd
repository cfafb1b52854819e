// Requests for accuracy or time that no sensor can meet.

robot scout {
    sensor sonar[4]: m in 15 cm .. 10 m  fails 10 m  accuracy 2.5 cm  period 60 ms
    sensor vague: m in 0 .. 10  fails 10  period 60 ms
    sensor untimed: m in 0 .. 10  fails 10  accuracy 2.5 cm
    sensor bumper: contact  fails set
    logical front = min(sonar[0..1]) within 1 cm
    logical ahead = sonar[0] within 200 ms
    logical whole = sonar[1] within 1 m

    logical exact     = sonar[0] within 1 mm            //~ error LM0309
    logical too_soon  = min(sonar[2..3]) within 50 ms   //~ error LM0309
    logical too_late  = sonar[0] within 1 min           //~ error LM0309
    logical nothing_  = sonar[0] within 0 cm            //~ error LM0309
    logical no_time   = sonar[0] within -1 s            //~ error LM0309
    logical all_of_it = sonar within 1 cm               //~ error LM0309
    logical of_group  = front within 1 cm               //~ error LM0309
    logical heavy     = sonar[0] within 1 kg            //~ error LM0301
    logical unknown   = vague within 1 cm               //~ error LM0311
    logical unpaced   = min(sonar[0], untimed) within 1 cm //~ error LM0311
    logical touched   = bumper within 200 ms            //~ error LM0309
    logical either    = any(bumper) within 200 ms       //~ error LM0309
    action halt()
}

behavior look on scout {
    entry go

    mode go {
        halt()
        1: front < 50 cm or ahead < 20 cm or whole < 20 cm -> stand
    }
    final mode stand { halt() }
}
