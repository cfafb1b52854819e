// Contacts that follow from conditions, interfaces that extend others, and what is wrong with them.
import std.networks.obstacle_id

interface moving {
    action halt()
    action go(speed: m/s)
}

interface feeling extends moving {
    sensor blocked: contact fails clear
    sensor low: contact fails set
    sense obstacle_id(left: blocked, right: low, force: low) //~ error LM0309
}

interface twice extends feeling {
    sensor low: contact //~ error LM0202
    action go(speed: m/s) //~ error LM0202
    action stop()
}

interface itself extends itself {} //~ error LM0205
interface missing extends nowhere {} //~ error LM0201

robot pusher provides feeling {
    body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
    sensor left: m/s^2 in -4 .. 4 fails 0 = wheel.left.acceleration
    sensor right: m/s^2 in -4 .. 4 fails 0 = wheel.right.acceleration
    sensor force: N in 0 .. 400 fails 0 = wedge.force
    sensor battery: V in 0 .. 15 fails 0
    sensor bumper[2]: contact fails set
    sense obstacle_id(left, right, force)
    sense obstacle_id(right, left, force) //~ error LM0202
    logical weakest = min(left, right)
    logical blocked = forward_collision or weakest < -3 m/s^2
    logical low = battery < 11 V or failed(battery)
    logical hit = force is high and not bumper[0]
    logical circular = circular and bumper[0] //~ error LM0309
    logical of_another = bumper[1] or hit //~ error LM0309
    logical number = battery //~ error LM0306
    logical several = bumper or hit //~ error LM0309
    logical slow = held(bumper[0], 200 ms) //~ error LM0316
    logical late = bumper[0] and after 2 s //~ error LM0316
    logical ready = done or bumper[0] //~ error LM0316
    logical often = count(bumper[0]) >= 2 //~ error LM0316
    logical nobody = no_event //~ error LM0201
    logical any_hit = any(bumper, hit) //~ error LM0309
    action halt() = body.stop()
    action go(speed: m/s) = body.velocity(speed, 0 deg/s)
}

robot deaf provides feeling { //~ error LM0312
    sensor bumper: contact fails set
    logical blocked = bumper
    logical low = min(bumper) //~ error LM0309
    action halt()
}

behavior careful on feeling {
    entry go

    mode go {
        go(0.2 m/s)
        1: blocked and not failed(blocked) -> stop
        2: low                             -> stop
    }
    mode stop {
        halt()
        1: not blocked and not low -> go
    }
}

behavior pushing on pusher {
    flag stuck = blocked and not low

    entry go

    mode go { //~ warning LM0604
        decide (stuck, hit) {
            (set,   _    ) => halt()
            (clear, set  ) => go(0.1 m/s)
            (clear, clear) => go(0.2 m/s)
        }
        1: hit -> stop
    }
    mode stop requires low else go {
        halt()
        1: not hit -> go
    }
}

scenario careful_pusher runs careful on pusher {
    duration 1 s
    fail blocked from 0.5 s
    fault blocked = set from 0.5 s //~ error LM0309
    fault weakest = -1 m/s^2 from 0.5 s
    expect never blocked or hit
}
