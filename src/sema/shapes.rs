//! The membership functions of terms.

use std::collections::HashMap;

use super::{Lower, claim, counted, given, invalid, missing_part, symbol};
use crate::base::{Dimension, Exact, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Part};
use crate::syntax::ast;

/// What a parameter of a shape is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Parameter {
    /// A reading.
    At,
    /// A difference of readings, above 0.
    Width,
    /// A number above 0.
    Power,
    /// A number for each of the variable's unit, not 0.
    Slope,
}

use Parameter::{At, Power, Slope, Width};

/// The shapes with names: their parameters, as they are written and what they are.
const SHAPES: &[(&str, &str, &[Parameter])] = &[
    ("triangle", "(a, b, c)", &[At, At, At]),
    ("trapezoid", "(a, b, c, d)", &[At, At, At, At]),
    ("ramp", "(zero_at, one_at)", &[At, At]),
    ("rectangle", "(a, b)", &[At, At]),
    ("singleton", "(x)", &[At]),
    ("gaussian", "(mean, sd)", &[At, Width]),
    ("gaussian2", "(mean1, sd1, mean2, sd2)", &[At, Width, At, Width]),
    ("bell", "(center, width, slope)", &[At, Width, Power]),
    ("sigmoid", "(inflection, slope)", &[At, Slope]),
    ("s_shape", "(a, b)", &[At, At]),
    ("z_shape", "(a, b)", &[At, At]),
    ("pi_shape", "(a, b, c, d)", &[At, At, At, At]),
    ("cosine", "(center, width)", &[At, Width]),
];

/// The shapes with names, each with its parameters as they are written: `ramp`, `(zero_at, one_at)`.
pub fn shapes() -> impl Iterator<Item = (&'static str, &'static str)> {
    SHAPES.iter().map(|(name, form, _)| (*name, *form)).chain([("points", "((x, degree), ...)")])
}

/// A term is built from at most so many parts.
const MOST_PARTS: usize = 256;

/// The terms of a variable while their shapes are lowered.
struct Terms<'t> {
    trees: HashMap<&'t str, &'t ast::Term>,
    unit: &'t Unit,
}

/// A shape being built.
#[derive(Default)]
struct Built<'t> {
    parts: Vec<Part>,
    /// The part that each term named so far is.
    known: HashMap<&'t str, u32>,
    /// The terms that lead here, each named by the one before.
    path: Vec<&'t ast::Name>,
}

impl Lower<'_> {
    /// The terms of a variable or output.
    pub(super) fn declared_terms(&mut self, trees: &[ast::Term], unit: &Unit) -> Vec<ir::Term> {
        let mut seen = HashMap::new();
        let (first, _): (Vec<_>, Vec<_>) =
            trees.iter().partition(|term| claim(&mut seen, &term.name, "term", &mut self.diagnostics));
        let terms = Terms { trees: first.iter().map(|term| (term.name.text.as_str(), *term)).collect(), unit };
        let lowered = first.iter().map(|term| {
            // A term whose shape is broken keeps its place, so that rules that name it are not reported too.
            let shape = self.term(term, &terms).unwrap_or(ir::Shape::Points(Vec::new()));
            ir::Term { symbol: symbol(&term.name, term.doc.as_ref()), shape, shape_span: term.shape.span }
        });
        lowered.collect()
    }

    fn term<'t>(&mut self, term: &'t ast::Term, terms: &Terms<'t>) -> Option<ir::Shape> {
        let mut built = Built { path: vec![&term.name], ..Built::default() };
        self.part(&term.shape, terms, &mut built)?;
        match built.parts.as_mut_slice() {
            [Part::Shape(_)] => built.parts.pop().and_then(|part| match part {
                Part::Shape(shape) => Some(shape),
                _ => None,
            }),
            _ => Some(ir::Shape::Built(built.parts)),
        }
    }

    /// Adds what a shape is built from, and answers its own part. Recursion is as deep as parentheses and as the path
    /// of terms, which are both limited.
    fn part<'t>(&mut self, shape: &'t ast::Shape, terms: &Terms<'t>, built: &mut Built<'t>) -> Option<u32> {
        let all = |lower: &mut Self, of: &'t [ast::Shape], built: &mut Built<'t>| {
            of.iter().map(|of| lower.part(of, terms, built)).collect::<Option<Vec<_>>>()
        };
        let part = match &shape.kind {
            ast::ShapeKind::Term(name) => return self.named_part(name, terms, built),
            ast::ShapeKind::Function { function, parameters } => {
                Part::Shape(self.function(function, parameters, terms.unit)?)
            }
            ast::ShapeKind::Points(points) => Part::Shape(self.points(shape, points, terms.unit)?),
            ast::ShapeKind::Not(of) => Part::Not(self.part(of, terms, built)?),
            ast::ShapeKind::Hedge(hedge, of) if hedge.text == "very" => Part::Very(self.part(of, terms, built)?),
            ast::ShapeKind::Hedge(_, of) => Part::Somewhat(self.part(of, terms, built)?),
            ast::ShapeKind::And(of) => Part::All(all(self, of, built)?),
            ast::ShapeKind::Or(of) => Part::Any(all(self, of, built)?),
        };
        if built.parts.len() == MOST_PARTS {
            self.report(invalid(shape.span, format!("a term is built from at most {MOST_PARTS} parts")));
            return None;
        }
        built.parts.push(part);
        Some(built.parts.len() as u32 - 1)
    }

    fn named_part<'t>(&mut self, name: &'t ast::Name, terms: &Terms<'t>, built: &mut Built<'t>) -> Option<u32> {
        let Some(term) = terms.trees.get(name.text.as_str()) else {
            let known: Vec<_> = terms.trees.keys().copied().collect();
            self.report(self.unknown(name, "term of this variable", known));
            return None;
        };
        self.refers(name.span, term.name.span);
        if let Some(known) = built.known.get(name.text.as_str()) {
            return Some(*known);
        }
        if let Some(start) = built.path.iter().position(|above| above.text == name.text) {
            // Each term of a circle leads to it; the first one in the text tells.
            let circle = &built.path[start..];
            if start == 0 && circle.iter().all(|other| other.span.start >= term.name.span.start) {
                self.report(circular_term(circle));
            }
            return None;
        }
        if built.path.len() == MOST_PARTS {
            self.report(invalid(name.span, format!("a term is built from at most {MOST_PARTS} parts")));
            return None;
        }
        self.read.insert(term.name.span);
        built.path.push(&term.name);
        let part = self.part(&term.shape, terms, built);
        built.path.pop();
        built.known.insert(&name.text, part?);
        part
    }

    fn points(
        &mut self,
        shape: &ast::Shape,
        points: &[(ast::Quantity, ast::Quantity)],
        unit: &Unit,
    ) -> Option<ir::Shape> {
        let mut corners = Vec::new();
        for (at, degree) in points {
            let at = self.quantity_in(at, unit);
            let degree_value = self.quantity_in(degree, &Unit::one());
            let (at, degree_value) = (at?, degree_value?);
            if degree_value < Exact::ZERO || degree_value > Exact::ONE {
                self.report(invalid(degree.span, "a degree of membership is between 0 and 1"));
                return None;
            }
            corners.push((at, degree_value));
        }
        if corners.is_empty() {
            self.report(missing_part(shape.span, "a shape needs at least one point"));
            return None;
        }
        Some(ir::Shape::Points(corners))
    }

    fn function(&mut self, function: &ast::Name, written: &[ast::Quantity], unit: &Unit) -> Option<ir::Shape> {
        let name = function.text.as_str();
        let Some(&(_, form, parameters)) = SHAPES.iter().find(|(known, ..)| *known == name) else {
            let known = SHAPES.iter().map(|(known, ..)| *known).chain(["points"]);
            self.report(self.unknown(function, "shape", known));
            return None;
        };
        if written.len() != parameters.len() {
            let count = counted(parameters.len(), "parameter");
            let message = format!("`{name}` takes {count}, {}", given(written.len()));
            let diagnostic = Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, function.span, message);
            self.report(diagnostic.help(format!("write `{name}{form}`")));
            return None;
        }
        let numbers: Vec<_> = parameters.iter().zip(written).map(|(is, at)| self.parameter(*is, at, unit)).collect();
        let numbers: Vec<Exact> = numbers.into_iter().collect::<Option<_>>()?;
        match (name, numbers.as_slice()) {
            ("triangle", &[a, b, c]) => Some(ir::Shape::Triangle([a, b, c])),
            ("trapezoid", &[a, b, c, d]) => Some(ir::Shape::Trapezoid([a, b, c, d])),
            ("ramp", &[zero_at, one_at]) => Some(ir::Shape::Ramp { zero_at, one_at }),
            ("rectangle", &[low, high]) => Some(ir::Shape::Rectangle([low, high])),
            ("singleton", &[at]) => Some(ir::Shape::Singleton(at)),
            ("gaussian", &[mean, sd]) => Some(ir::Shape::Gaussian([mean, sd])),
            ("gaussian2", &[low, below, high, above]) => Some(ir::Shape::Gaussian2([low, below, high, above])),
            ("bell", &[center, width, slope]) => Some(ir::Shape::Bell([center, width, slope])),
            ("sigmoid", &[inflection, slope]) => Some(ir::Shape::Sigmoid([inflection, slope])),
            ("s_shape", &[a, b]) => Some(ir::Shape::Rise([a, b])),
            ("z_shape", &[a, b]) => Some(ir::Shape::Fall([a, b])),
            ("pi_shape", &[a, b, c, d]) => Some(ir::Shape::RiseAndFall([a, b, c, d])),
            ("cosine", &[center, width]) => Some(ir::Shape::Cosine([center, width])),
            _ => None,
        }
    }

    fn parameter(&mut self, is: Parameter, written: &ast::Quantity, unit: &Unit) -> Option<Exact> {
        let value = match is {
            At | Width => self.quantity_in(written, unit),
            Power => self.quantity_in(written, &Unit::one()),
            Slope => self.quantity_in(written, &per(unit)?),
        }?;
        let wrong = match is {
            Width if value <= Exact::ZERO => "the width of a shape is above 0",
            Power if value <= Exact::ZERO => "the slope of a bell is above 0",
            Slope if value.is_zero() => "the slope of a sigmoid is not 0",
            _ => return Some(value),
        };
        self.report(invalid(written.span, wrong));
        None
    }
}

/// The unit of what there is for each one of a unit.
fn per(unit: &Unit) -> Option<Unit> {
    let dimension = Dimension::NONE.times(unit.dimension, -1)?;
    let text = if unit.text.contains(['/', '*']) { format!("1/({})", unit.text) } else { format!("1/{}", unit.text) };
    Some(Unit { text, scale: Exact::ONE.over(unit.scale)?, dimension })
}

fn circular_term(circle: &[&ast::Name]) -> Diagnostic {
    let list: Vec<_> = circle.iter().chain(circle.first()).map(|name| format!("`{}`", name.text)).collect();
    let span = circle.first().map(|name| name.span).unwrap_or_default();
    let diagnostic = match circle {
        [one] => Diagnostic::new(&diag::rules::CIRCULAR, span, format!("the term `{}` needs itself", one.text)),
        _ => Diagnostic::new(&diag::rules::CIRCULAR, span, "terms need each other in a circle")
            .note(format!("the circle: {}", list.join(" needs "))),
    };
    diagnostic.help("one of them must be a shape of its own, such as `ramp(80, 20)`")
}
