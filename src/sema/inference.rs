//! `using { ... }`: what `and`, `or`, implication, aggregation and defuzzification are in a network.

use std::collections::HashMap;

use super::{Lower, invalid, said_twice};
use crate::diag::{self, Diagnostic};
use crate::ir::{AGGREGATIONS, DEFUZZIFIERS, Defuzzifier, IMPLICATIONS, Inference, S_NORMS, T_NORMS};
use crate::syntax::ast::{Name, Number, Setting, SettingValue};

const KEYS: [&str; 5] = ["and", "or", "implication", "aggregation", "defuzzify"];

/// The most parts of a range that `midpoints` takes.
const MOST_MIDPOINTS: u32 = 10_000;

impl Lower<'_> {
    pub(super) fn inference(&mut self, settings: &[Setting]) -> Inference {
        let mut inference = Inference::default();
        let mut seen = HashMap::new();
        for setting in settings {
            if !KEYS.contains(&setting.key.text.as_str()) {
                self.report(self.unknown(&setting.key, "choice of inference", KEYS));
            } else if let Some(first) = seen.insert(&setting.key.text, setting.span) {
                self.report(said_twice(setting.span, first, &format!("`{}`", setting.key.text)));
            } else {
                self.setting(setting, &mut inference);
            }
        }
        inference
    }

    fn setting(&mut self, setting: &Setting, inference: &mut Inference) {
        let (value, number) = match setting.values.as_slice() {
            [SettingValue::Name(value)] => (value, None),
            [SettingValue::Name(value), SettingValue::Name(word), SettingValue::Number(number)]
                if value.text == "centroid" && word.text == "midpoints" && setting.key.text == "defuzzify" =>
            {
                (value, Some(number))
            }
            _ => {
                let message = format!("`{}` takes one name", setting.key.text);
                let example = if setting.key.text == "defuzzify" {
                    "`defuzzify centroid`, or `defuzzify centroid midpoints 200`"
                } else {
                    "`and product`"
                };
                return self.report(invalid(setting.span, message).help(format!("write for instance {example}")));
            }
        };
        match setting.key.text.as_str() {
            "and" => self.choose(value, "t-norm", T_NORMS, &mut inference.and),
            "or" => self.choose(value, "s-norm", S_NORMS, &mut inference.or),
            "implication" => self.choose(value, "implication", IMPLICATIONS, &mut inference.implication),
            "aggregation" => self.choose(value, "aggregation", AGGREGATIONS, &mut inference.aggregation),
            _ => self.choose(value, "defuzzifier", DEFUZZIFIERS, &mut inference.defuzzifier),
        }
        if let Some(parts) = number.and_then(|number| self.midpoints(number)) {
            inference.defuzzifier = Defuzzifier::Midpoints(parts);
        }
    }

    fn choose<T: Copy>(&mut self, value: &Name, what: &str, known: &[(&str, T)], choice: &mut T) {
        match known.iter().find(|(name, _)| *name == value.text) {
            Some((_, chosen)) => *choice = *chosen,
            None => self.report(self.unknown(value, what, known.iter().map(|(name, _)| *name))),
        }
    }

    fn midpoints(&mut self, number: &Number) -> Option<u32> {
        let parts = self.whole(number, 1, "a number of midpoints")?;
        let parts = u32::try_from(parts).ok().filter(|parts| *parts <= MOST_MIDPOINTS);
        if parts.is_none() {
            self.report(invalid(number.span, format!("at most {MOST_MIDPOINTS} midpoints can be taken")));
        }
        parts
    }

    /// Reports choices that nothing is inferred by.
    pub(super) fn idle_inference(&mut self, settings: &[Setting]) {
        if let (Some(first), Some(last)) = (settings.first(), settings.last()) {
            let message = "these choices concern outputs, and the network has none";
            let diagnostic = Diagnostic::new(&diag::rules::INVALID_VALUE, first.span.to(last.span), message);
            self.report(
                diagnostic.note("the rules of an event are always minimum and maximum").help("take `using` out"),
            );
        }
    }
}
