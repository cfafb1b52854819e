interface base {
    action halt()
    action drive(speed: m/s)
}
