import std.behaviors.obstacle_avoidance
import std.robots.j5

scenario one runs obstacle_avoidence on j5 { //~ error LM0201
    duration 3 s
    expect modes init, forward
}

scenario two extends three { //~ error LM0201
    duration 3 s
}

scenario four runs obstacle_avoidance on j5 in hallway { //~ error LM0201
    duration 3 s
    fault contact_farce = 0 N //~ error LM0201
    fail force from 2 s //~ error LM0201
    expect modes init, foward //~ error LM0201
    expect forward -> halt within 1 s .. 2 s //~ error LM0201
    expect never blokced //~ error LM0201
}
