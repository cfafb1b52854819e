//! SVG text, a few elements at a time.

use std::fmt::{self, Display, Write};

/// A drawing under way. Lengths are px of a sheet that scales to any size.
#[derive(Default)]
pub(super) struct Svg {
    text: String,
}

/// A coordinate with one decimal, which is as fine as a sheet needs, and without needless characters.
#[derive(Clone, Copy)]
pub(super) struct Px(pub(super) f64);

impl Display for Px {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // A number that is not finite would make the whole drawing invalid.
        let tenths = if self.0.is_finite() { (self.0.clamp(-1e6, 1e6) * 10.0).round() as i64 } else { 0 };
        let (sign, tenths) = (if tenths < 0 { "-" } else { "" }, tenths.abs());
        match tenths % 10 {
            0 => write!(f, "{sign}{}", tenths / 10),
            tenth => write!(f, "{sign}{}.{tenth}", tenths / 10),
        }
    }
}

/// Text with what XML reserves written as entities, and without what XML forbids.
pub(super) struct Escaped<'a>(pub(super) &'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for character in self.0.chars() {
            match character {
                '&' => f.write_str("&amp;")?,
                '<' => f.write_str("&lt;")?,
                '>' => f.write_str("&gt;")?,
                '"' => f.write_str("&quot;")?,
                '\n' | '\r' | '\t' => f.write_char(' ')?,
                '\u{fffe}' | '\u{ffff}' => {}
                control if control.is_control() => {}
                other => f.write_char(other)?,
            }
        }
        Ok(())
    }
}

/// Which end of a text its position is.
#[derive(Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

impl Svg {
    /// Adds markup as it is.
    pub(super) fn raw(&mut self, markup: impl Display) {
        let _ = writeln!(self.text, "{markup}");
    }

    pub(super) fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        let (x1, y1, x2, y2) = (Px(from.0), Px(from.1), Px(to.0), Px(to.1));
        self.raw(format_args!(r#"<path class="{class}" d="M{x1} {y1}L{x2} {y2}"/>"#));
    }

    /// Draws path data in a color of its own.
    pub(super) fn path(&mut self, class: &str, color: &str, width: f64, data: &str) {
        if !data.is_empty() {
            self.raw(format_args!(r#"<path class="{class}" stroke="{color}" stroke-width="{width}" d="{data}"/>"#));
        }
    }

    /// Draws path data as its class says.
    pub(super) fn shape(&mut self, class: &str, data: &str) {
        if !data.is_empty() {
            self.raw(format_args!(r#"<path class="{class}" d="{data}"/>"#));
        }
    }

    pub(super) fn text(&mut self, class: &str, at: (f64, f64), anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let (x, y, text) = (Px(at.0), Px(at.1), Escaped(text));
        self.raw(format_args!(r#"<text class="{class}" x="{x}" y="{y}"{anchor}>{text}</text>"#));
    }

    /// Text that is read from below, centered on its position.
    pub(super) fn upward_text(&mut self, class: &str, at: (f64, f64), text: &str) {
        let (x, y, text) = (Px(at.0), Px(at.1), Escaped(text));
        let turned = format!(r#"transform="translate({x} {y}) rotate(-90)""#);
        self.raw(format_args!(r#"<text class="{class}" {turned} text-anchor="middle">{text}</text>"#));
    }

    /// Text cut to `width` px, with the whole of it for whoever points at it.
    pub(super) fn cut_text(&mut self, class: &str, at: (f64, f64), anchor: Anchor, text: &str, width: f64) {
        let short = cut(text, width);
        if short == text {
            self.text(class, at, anchor, text);
        } else {
            self.raw(format_args!("<g><title>{}</title>", Escaped(text)));
            self.text(class, at, anchor, &short);
            self.raw("</g>");
        }
    }

    pub(super) fn into_text(self) -> String {
        self.text
    }
}

/// The width of text of the sheet's size in px. Fonts differ: this is on the wide side, so that what is laid out by
/// it does not collide.
pub(super) fn width_of(text: &str) -> f64 {
    text.chars().count() as f64 * 6.6
}

/// As much of a text as fits into `width` px.
pub(super) fn cut(text: &str, width: f64) -> String {
    if width_of(text) <= width {
        return text.to_owned();
    }
    let fitting = (width / width_of("m")).floor().max(2.0) as usize - 1;
    text.chars().take(fitting).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn coordinates_are_short_and_finite() {
        let shown = [0.0, -0.04, 1.25, -3.0, 12.349, f64::NAN, f64::INFINITY, -0.5].map(|px| Px(px).to_string());
        assert_eq!(shown, ["0", "0", "1.3", "-3", "12.3", "0", "0", "-0.5"]);
    }

    #[test]
    fn text_is_escaped_and_cut() {
        assert_eq!(Escaped("a<b & \"c\"\u{0}\n").to_string(), "a&lt;b &amp; &quot;c&quot; ");
        assert_eq!(cut("short", 100.0), "short");
        assert_eq!(cut("a_rather_long_name", 66.0), "a_rather_…");
        assert_eq!(cut("abc", 0.0), "a…");
    }
}
