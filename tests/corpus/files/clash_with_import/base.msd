interface base {
    action halt()
}
