// Where a declaration names its unit, a plain number takes it.
interface base {
    action ring(times: 1)
    action power(share: %)
}

robot rover provides base {
    sensor force: kN in 0 .. 0.4  fails 0, 100 N, any, absent  = wedge.force  noise 2 N
    sensor share: % in 0 .. 100  fails 50
    action ring(times: 1)
    action power(share: %)
}

behavior ring on rover {
    entry go

    mode go {
        ring(3)
        power(0.5)
        1: force > 100 N -> again
        2: share < 30 %  -> again
        3: share > 0.9   -> again
    }
}
