; What each node is, by the names that Neovim and Helix share. No node is captured twice, so that it does not matter
; whether the first or the last pattern wins.

(comment) @comment
(doc_comment) @comment.documentation

[
  "absent" "accuracy" "action" "activity" "after" "again" "ahead" "always" "any" "arbiter" "at" "beam" "before" "behavior"
  "body" "box" "clear" "client" "confirm" "contact" "contributor" "decide" "default" "detractor" "door" "duration" "else"
  "emergency" "enter" "entry" "event" "exit" "expect" "extends" "fail" "fails" "fault" "final" "flag" "from" "goal"
  "heading" "hold" "hysteresis" "import" "in" "interface" "leads" "logical" "mass" "mode" "modes" "network" "never"
  "noise" "nothing" "of" "on" "open" "optional" "output" "over" "period" "place" "points" "priority" "property"
  "provides" "requires" "resume" "robot" "rule" "runs" "scenario" "seed" "sense" "sensor" "set" "size" "somewhat"
  "takagi_sugeno" "team" "tick" "ties" "to" "using" "variable" "very" "wall" "weight" "when" "width" "within" "world"
] @keyword

["and" "is" "not" "or"] @keyword.operator
(done) @keyword
(action "done" @keyword)

["->" "=>" "=" "<" "<=" ">" ">=" "==" "!=" "+" "-" "*" "/" ".."] @operator
["{" "}" "(" ")" "[" "]"] @punctuation.bracket
["," ":" "."] @punctuation.delimiter

(number) @number
(priority) @number
(unit) @type.builtin
(wildcard) @constant.builtin

(module_path) @module
(variable name: (identifier) @type)
(input name: (identifier) @variable.parameter variable: (identifier) @type)
(type_name) @type
(interface name: (identifier) @type)
(robot name: (identifier) @type)
(diagram name: (identifier) @type)
(arbiter name: (identifier) @type)
(team name: (identifier) @type)
(world name: (identifier) @type)
(scenario name: (identifier) @type)
(body name: (identifier) @type)
(client name: (identifier) @type)
(member name: (identifier) @variable)
(box name: (identifier) @variable)
(place_robot name: (identifier) @variable)

(network name: (identifier) @module)
(sense alias: (identifier) @module)
(sense network: (identifier) @module)
(event name: (identifier) @variable)
(event "(" (identifier) @variable)
(output name: (identifier) @property)
(consequent output: (identifier) @property)
(property name: (identifier) @variable)
(flag name: (identifier) @variable)
(ties (identifier) @constant)
(setting (identifier) @constant)

(term name: (identifier) @constant)
(term_name) @constant
(mode name: (identifier) @label)
(mode_name) @label
(mode "requires" (identifier) @property)

(sensor name: (identifier) @property)
(logical name: (identifier) @property)
(parameter_value name: (identifier) @property)
(parameter name: (identifier) @variable.parameter)
(argument name: (identifier) @variable.parameter)
(path . (identifier) @variable)
(path member: (identifier) @property)

(action name: (identifier) @function)
(shape function: (identifier) @function)
(function_path) @function
