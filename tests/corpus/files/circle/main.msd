// The circle is found wherever one begins to read.
import avoid
