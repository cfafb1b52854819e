// A property whose file knows no behavior.
property calm: never stop //~ error LM0311
