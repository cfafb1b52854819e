//! A text of any length.

/// A behavior of so many lines, five to a mode.
pub fn behavior(lines: usize) -> String {
    let modes = lines / 5;
    let mut text = "import std.robots.j5\nbehavior big on j5 {\n    entry m0\n".to_owned();
    for mode in 0..modes {
        let (next, far) = ((mode + 1) % modes, (mode * 7 + 3) % modes);
        text += &format!(
            "    mode m{mode} {{\n        drive(26 cm/s)\n        1: after 100 ms and contact_force > 10 N and not failed(contact_force) -> m{far}\n        2: after 2 s -> m{next}\n    }}\n"
        );
    }
    text + "}\n"
}
