import collision //~ error LM0006
