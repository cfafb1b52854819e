import left
import right //~ error LM0203
