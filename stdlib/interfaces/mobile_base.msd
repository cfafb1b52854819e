/// What a behavior may ask of any base that moves.
interface mobile_base {
    /// Stands still.
    action halt()
    /// Drives straight ahead, or back for a negative speed.
    action drive(speed: m/s)
    /// Drives along a circle, to the left for a positive radius.
    action arc(speed: m/s, radius: m)
    /// Turns in place, to the left for a positive angle.
    action turn(angle: deg) -> done
}
