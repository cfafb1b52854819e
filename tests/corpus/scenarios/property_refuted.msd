// Every kind of property, broken by a run that is shown.
import std.behaviors.obstacle_manipulation

property gentle: never push and contact_force > 100 N //~ error LM0804
property ready: always not failed(left_wheel_acceleration) or init //~ error LM0804
property quick: stop leads to random_turn within 2 s //~ error LM0804
property back: stop leads to forward within 10 s //~ error LM0804
property no_blind_push: never push and failed(contact_force)
