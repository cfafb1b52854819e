// What the manipulation behavior of the library never does, and what it always does in time: `lmslc check` proves it for
// every reading, every tick of at most 10 ms, and with any one sensor failed.
//
// The paper's "a mode is inhibited while an essential sensor is faulted" (Born & Wright 2007, section 2.1) is
// `no_blind_push`. That obstacles which are too heavy are collisions too, so that nothing heavy is ever pushed, follows
// from eqs. 6 to 9.

import manipulation
import std.behaviors.obstacle_manipulation

/// Never pushes without the sensor that tells light from heavy.
property no_blind_push: never push and failed(contact_force)

/// Lets go of what turns out to be heavy on the very tick.
property gentle: never push and heavy_obstacle

/// Whatever is heavy was hit.
property flags_agree: always forward_collision or not heavy_obstacle

/// A push is given up after 4 s.
property no_endless_push: push leads to not push within 4 s

/// Half a second after it stopped the robot backs up, and 1.5 s later it turns; the second timer may be a tick late.
property backs_up: stop leads to back_up within 500 ms
property turns_away: stop leads to random_turn within 2.01 s

/// The experiment again, with an eye on all of this.
scenario watched extends manipulation {
    expect modes init, forward, push, stop, back_up
}
