import std.robots.j5

behavior wander on j5 { //~ error LM0401
}
