import a
variable v: m { low = ramp(0, 1) }
network n(a: v) { event e { contributor (low) } }
interface i { }
nonsense
