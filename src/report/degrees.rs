//! One evaluation of a network for people: degrees as bars, the rules that fired, and who outweighed whom.

use std::fmt::Write;

use super::eval::Evaluated;
use super::paint::Paint;
use crate::kernel;
use crate::plan::Real;

/// Characters of a bar that stands for a degree of 1.
const BAR: f64 = 20.0;
/// How many rules of a side are listed.
const LISTED: usize = 4;

/// Renders an evaluation: every input with its degrees of membership, then every event with the strength of its
/// contributor and detractor, the rules that fired by their number from 1, the margin and the flag, then every output
/// with its value and the rules that fired. Readings and outputs are in the unit in which the network declares them. `color` adds ANSI escapes.
pub fn eval(evaluated: &Evaluated<'_>, color: bool) -> String {
    let paint = Paint { color };
    let plan = evaluated.plan;
    let mut out = format!("{}\n", paint.bold(&plan.name));
    let names = plan.degrees.iter().flatten().map(|(term, _)| term.chars().count());
    let width = names.max().unwrap_or(0).max("contributor".len());
    for (index, input) in plan.inputs.iter().enumerate() {
        let _ = writeln!(out, "\n  {}  {}", paint.bold(&input.name), reading(evaluated, index));
        for (term, degree) in plan.degrees.get(index).into_iter().flatten() {
            let _ = writeln!(out, "    {term:width$}  {}", bar(evaluated.evaluator.real(*degree), &paint));
        }
    }
    for (index, event) in plan.events.iter().enumerate() {
        let flag = evaluated.evaluator.bool(event.flag);
        let state = if flag { paint.good("set") } else { paint.faint("not set") };
        let _ = writeln!(out, "\n  {}  {state}", paint.bold(&event.name));
        let (contributor, detractor) = (evaluated.contributor(event), evaluated.detractor(event));
        let strengths = plan.strengths.get(index);
        let sides = [
            ("contributor", contributor, strengths.map(|(contributor, _)| contributor)),
            ("detractor", detractor, strengths.map(|(_, detractor)| detractor)),
        ];
        for (side, strength, rules) in sides {
            let fired = fired(evaluated, rules.map_or(&[], Vec::as_slice));
            let _ = writeln!(out, "    {side:width$}  {}  {fired}", bar(strength, &paint));
        }
        let _ = writeln!(out, "    {:width$}  {:+.3}", "margin", contributor - detractor);
    }
    for output in &plan.outputs {
        let value = output.unit.show(evaluated.evaluator.real(output.value));
        let _ = writeln!(out, "\n  {}  {value}", paint.bold(&output.name));
        let fired = fired(evaluated, &output.strengths);
        let strengths = output.strengths.iter().map(|&rule| evaluated.evaluator.real(rule));
        let strongest = strengths.fold(0.0, kernel::maximum);
        let _ = writeln!(out, "    {:width$}  {}  {fired}", "strongest", bar(strongest, &paint));
    }
    out
}

/// The reading in its declared unit, and what stands in for it where it is not usable.
fn reading(evaluated: &Evaluated<'_>, index: usize) -> String {
    let Some(input) = evaluated.plan.inputs.get(index) else { return String::new() };
    let reading = evaluated.reading(index);
    let safe = kernel::sanitize(reading.value, reading.healthy, input.low, input.high, input.fail);
    let safe_text = input.unit.show(safe);
    if !reading.healthy {
        format!("failed, taken as {safe_text}")
    } else if !reading.value.is_finite() {
        format!("not a finite number, taken as {safe_text}")
    } else if safe != reading.value {
        format!("{}, out of range, taken as {safe_text}", input.unit.show(reading.value))
    } else {
        safe_text
    }
}

fn bar(degree: f64, paint: &Paint) -> String {
    // A degree above 0 has at least one cell, and one below 1 never all: the ends mean something.
    let cells = match (degree * BAR).round() {
        _ if degree <= 0.0 => 0.0,
        _ if degree >= 1.0 => BAR,
        cells => cells.clamp(1.0, BAR - 1.0),
    };
    let (full, rest) = (cells as usize, (BAR - cells) as usize);
    format!("{}{}  {degree:.3}", "█".repeat(full), paint.faint(&"·".repeat(rest)))
}

/// The rules that fired, strongest first.
fn fired(evaluated: &Evaluated<'_>, rules: &[Real]) -> String {
    let strengths = rules.iter().map(|&rule| evaluated.evaluator.real(rule)).zip(1..);
    let mut fired: Vec<(f64, usize)> = strengths.filter(|&(strength, _)| strength > 0.0).collect();
    fired.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let listed = fired.iter().take(LISTED).map(|(strength, rule)| format!("rule {rule} {strength:.3}"));
    let listed = listed.collect::<Vec<_>>().join(", ");
    match fired.len() {
        0 => format!("none of {} rules", rules.len()),
        more if more > LISTED => format!("{listed} and {} more", more - LISTED),
        _ => listed,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::{Evaluator, Reading};
    use crate::report::samples;

    fn shown(readings: [(f64, bool); 2]) -> String {
        let plan = samples::network();
        let mut evaluator = Evaluator::new(&plan);
        let readings = readings.map(|(value, healthy)| Reading { value, healthy });
        evaluator.evaluate(&readings, 0);
        eval(&Evaluated { plan: &plan, evaluator: &evaluator, readings: &readings }, false)
    }

    #[test]
    fn degrees_are_bars_and_rules_have_numbers() {
        insta::assert_snapshot!(shown([(-0.75, true), (118.0, true)]), @r#"
        obstacle_id

          left  -0.75 m/s^2
            neg          ███████████████·····  0.750
            zero         █████···············  0.250

          force  118 N
            low          ████████············  0.410
            high         ████████████········  0.590

          forward_collision  set
            contributor  ████████████········  0.590  rule 2 0.590, rule 1 0.410
            detractor    █████···············  0.250  rule 1 0.250
            margin       +0.340
        "#);
    }

    #[test]
    fn what_stands_in_for_a_reading_is_said() {
        let text = shown([(-70.0, true), (118.0, false)]);
        assert!(text.contains("left  -70 m/s^2, out of range, taken as -4 m/s^2"), "{text}");
        assert!(text.contains("force  failed, taken as 0 N"), "{text}");
        assert!(shown([(f64::NAN, true), (0.0, true)]).contains("left  not a finite number, taken as 0 m/s^2"));
    }

    #[test]
    fn the_ends_of_a_bar_mean_zero_and_one() {
        let cells = |degree| bar(degree, &Paint { color: false }).matches('█').count();
        assert_eq!([0.0, 0.001, 0.5, 0.999, 1.0].map(cells), [0, 1, 10, 19, 20]);
    }
}
