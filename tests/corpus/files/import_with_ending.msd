import bump.fsfn //~ error LM0003
