// Properties that do not say what they must.
import std.behaviors.obstacle_avoidance
import std.behaviors.obstacle_manipulation

property no_push: never push and failed(contact_force)
property no_turn: never random_turn and back_up //~ error LM0206
property some_day: push leads to stop //~ error LM0311
property at_once: push leads to stop within 0 s //~ error LM0309
property quiet of obstacle_avoidence: never forward_collision //~ error LM0201
property bare of obstacle_manipulation: never contact_force //~ error LM0306
property blind of j5: never forward_collision //~ error LM0201
property unknown of obstacle_avoidance: never push //~ error LM0201
