import main //~ error LM0004
