import j5 //~ error LM0003
import robots.j5 //~ error LM0003
