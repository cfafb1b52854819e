import base //~ error LM0203

interface base {
    action stop()
}
