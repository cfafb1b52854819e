//! Emits steps, each value once.

use std::collections::HashMap;
use std::ops::Range;

use super::platform::{Feed, Platform};
use super::{Bool, Code, Logical, Real, Shape, Step, Steps, Value};
use crate::base::{Exact, Id};
use crate::ir;

/// What a value is computed from; two values computed from the same are one.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) enum Key {
    Read(u32),
    Average(Real, u32),
    Group(ir::Grouping, Vec<Real>),
    Constant(u64),
    Degree(Real, ir::Shape),
    Complement(Real),
    Very(Real),
    Somewhat(Real),
    Minimum(Vec<Real>),
    Maximum(Vec<Real>),
    TNorm(ir::TNorm, Real, Real),
    SNorm(ir::SNorm, Real, Real),
    Weigh(Real, u64),
    Fires(Real),
    Failed(u32),
    Compare(ir::Comparison, Real, Real),
    After(u64),
    Done,
    InMode(u32),
    Inside(Vec<u32>),
    Held(Bool, u64),
    Rising(Bool),
    Falling(Bool),
    Latched(Bool),
    Count(Bool),
    Not(Bool),
    All(Vec<Bool>),
    Any(Vec<Bool>),
}

/// An event of the plan being built: where its contributor, its detractor and its flag are, and its rules' strengths.
pub(super) struct EventSlots {
    pub(super) contributor: Real,
    pub(super) detractor: Real,
    pub(super) flag: Bool,
    pub(super) strengths: (Vec<Real>, Vec<Real>),
}

/// What conditions look up while they are emitted.
pub(super) struct Names<'a> {
    /// The robot or interface with its sensors.
    pub(super) platform: Platform<'a>,
    /// The robot's logical sensors.
    pub(super) logical: &'a [Logical],
    /// The flag of each event, by sense.
    pub(super) events: &'a [Vec<Bool>],
    /// The value of each output, by sense.
    pub(super) outputs: &'a [Vec<Real>],
    /// The named flags that have been emitted.
    pub(super) flags: &'a [Bool],
}

impl Names<'_> {
    /// Whether this is the reading of a contact that follows from a condition.
    fn is_condition(&self, op: &ir::Op) -> bool {
        let ir::Op::Sensor(sensor) = op else { return false };
        let Feed::Logical(place) = self.platform.feed(*sensor) else { return false };
        matches!(self.logical[place as usize].value, Value::Truth(_))
    }
}

/// Steps in the order in which they run. Values of the common part are shared by all; values emitted after
/// [`Builder::begin_part`] only within their part, because a part may not run on every tick.
pub(super) struct Builder<'a> {
    pub(super) program: &'a ir::Program,
    pub(super) code: Code,
    common: HashMap<Key, u32>,
    part: Option<HashMap<Key, u32>>,
    /// Whether the part runs after a transition may have been taken.
    after_select: bool,
    constants: Vec<Step>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(program: &'a ir::Program) -> Self {
        Self {
            program,
            code: Code::default(),
            common: HashMap::new(),
            part: None,
            after_select: false,
            constants: Vec::new(),
        }
    }

    /// Where the next step will stand.
    pub(super) fn position(&self) -> u32 {
        self.code.steps.len() as u32
    }

    /// From here on values are shared only until the next part begins.
    pub(super) fn begin_part(&mut self) {
        self.part = Some(HashMap::new());
    }

    /// From here on steps run after a transition may have been taken: what belongs to the mode is read anew.
    pub(super) fn begin_watch(&mut self) {
        self.begin_part();
        self.after_select = true;
    }

    /// Appends the fixed numbers and answers where they stand.
    pub(super) fn finish(&mut self) -> Steps {
        let start = self.position();
        self.code.steps.append(&mut self.constants);
        start..self.position()
    }

    pub(super) fn new_real(&mut self) -> Real {
        self.code.reals += 1;
        self.code.reals - 1
    }

    fn new_bool(&mut self) -> Bool {
        self.code.bools += 1;
        self.code.bools - 1
    }

    fn known(&self, key: &Key) -> Option<u32> {
        let of_mode = matches!(key, Key::After(_) | Key::Latched(_) | Key::Count(_));
        let common = self.common.get(key).filter(|_| !(self.after_select && of_mode));
        common.or_else(|| self.part.as_ref()?.get(key)).copied()
    }

    fn remember(&mut self, key: Key, slot: u32) {
        self.part.as_mut().unwrap_or(&mut self.common).insert(key, slot);
    }

    pub(super) fn real(&mut self, key: Key, step: impl FnOnce(&mut Code, Real) -> Step) -> Real {
        self.known(&key).unwrap_or_else(|| {
            let to = self.new_real();
            let step = step(&mut self.code, to);
            self.code.steps.push(step);
            self.remember(key, to);
            to
        })
    }

    pub(super) fn bool(&mut self, key: Key, step: impl FnOnce(&mut Code, Bool) -> Step) -> Bool {
        self.known(&key).unwrap_or_else(|| {
            let to = self.new_bool();
            let step = step(&mut self.code, to);
            self.code.steps.push(step);
            self.remember(key, to);
            to
        })
    }

    pub(super) fn read(&mut self, input: u32) -> Real {
        self.real(Key::Read(input), |_, to| Step::Read { input, to })
    }

    /// The mean of the last `count` readings of an input, one every `period` nanoseconds; its reading for one.
    pub(super) fn average(&mut self, input: u32, count: u32, period: u64) -> Real {
        let of = self.read(input);
        if count == 1 {
            return of;
        }
        self.real(Key::Average(of, count), |code, to| {
            let readings = code.readings..code.readings + count;
            code.readings = readings.end;
            Step::Average { input, of, period, window: next(&mut code.windows), readings, to }
        })
    }

    /// One reading from several.
    pub(super) fn group(&mut self, how: ir::Grouping, of: &[Real]) -> Real {
        if let (&[single], false) = (of, matches!(how, ir::Grouping::Widest { .. })) {
            return single;
        }
        self.real(Key::Group(how, of.to_vec()), |code, to| Step::Group {
            how: how.map(Exact::to_f64),
            of: list(&mut code.real_lists, of),
            to,
        })
    }

    /// What a sensor reads; of a contact that follows from a condition, whether it is set.
    pub(super) fn sensor(&mut self, sensor: Id<ir::Sensor>, platform: Platform<'_>, logical: &[Logical]) -> u32 {
        match platform.feed(sensor) {
            Feed::Input(input) => self.read(input),
            Feed::Logical(place) => match logical[place as usize].value {
                Value::Truth(value) | Value::Number(value) => value,
            },
        }
    }

    fn failed(&mut self, input: u32) -> Bool {
        self.bool(Key::Failed(input), |_, to| Step::Failed { input, to })
    }

    fn any(&mut self, of: &[Bool]) -> Bool {
        self.bool(Key::Any(of.to_vec()), |code, to| Step::Any { of: list(&mut code.bool_lists, of), to })
    }

    /// A fixed number; it is written once before the first tick, so it is shared by all parts.
    pub(super) fn constant(&mut self, value: f64) -> Real {
        let key = Key::Constant(value.to_bits());
        if let Some(&to) = self.common.get(&key) {
            return to;
        }
        let to = self.new_real();
        self.constants.push(Step::Constant { value, to });
        self.common.insert(key, to);
        to
    }

    pub(super) fn degree(&mut self, of: Real, variable: Id<ir::Variable>, term: u32) -> Real {
        let program = self.program;
        let shape = &program.variables[variable].terms[term as usize].shape;
        let ir::Shape::Built(parts) = shape else { return self.shape(of, shape) };
        let mut degrees: Vec<Real> = Vec::with_capacity(parts.len());
        for part in parts {
            let some = |of: &[u32]| of.iter().map(|&of| degrees[of as usize]).collect::<Vec<_>>();
            let degree = match part {
                ir::Part::Shape(shape) => self.shape(of, shape),
                ir::Part::Not(of) => self.complement(degrees[*of as usize]),
                ir::Part::Very(of) => {
                    let of = degrees[*of as usize];
                    self.real(Key::Very(of), |_, to| Step::Very { of, to })
                }
                ir::Part::Somewhat(of) => {
                    let of = degrees[*of as usize];
                    self.real(Key::Somewhat(of), |_, to| Step::Somewhat { of, to })
                }
                ir::Part::All(of) => self.minimum(&some(of)),
                ir::Part::Any(of) => self.maximum(&some(of)),
            };
            degrees.push(degree);
        }
        degrees.last().copied().unwrap_or_else(|| self.constant(0.0))
    }

    fn shape(&mut self, of: Real, shape: &ir::Shape) -> Real {
        self.real(Key::Degree(of, shape.clone()), |code, to| Step::Degree { of, shape: lower_shape(shape, code), to })
    }

    pub(super) fn complement(&mut self, of: Real) -> Real {
        self.real(Key::Complement(of), |_, to| Step::Complement { of, to })
    }

    pub(super) fn minimum(&mut self, of: &[Real]) -> Real {
        if let &[single] = of {
            return single;
        }
        self.real(Key::Minimum(of.to_vec()), |code, to| Step::Minimum { of: list(&mut code.real_lists, of), to })
    }

    pub(super) fn maximum(&mut self, of: &[Real]) -> Real {
        if let &[single] = of {
            return single;
        }
        self.real(Key::Maximum(of.to_vec()), |code, to| Step::Maximum { of: list(&mut code.real_lists, of), to })
    }

    /// The events of a network whose inputs have been read.
    pub(super) fn events(&mut self, network: Id<ir::Network>, readings: &[Real]) -> Vec<EventSlots> {
        let network = &self.program.networks[network];
        network.events.iter().map(|event| self.event(event, &network.inputs, readings)).collect()
    }

    fn event(&mut self, event: &ir::Event, inputs: &[ir::NetworkInput], readings: &[Real]) -> EventSlots {
        let mut side = |rules: &[ir::Rule]| -> Vec<Real> {
            rules.iter().map(|rule| self.strength(rule, inputs, readings)).collect()
        };
        let strengths = (side(&event.contributor), side(&event.detractor));
        let contributor = self.maximum(&strengths.0);
        let detractor = self.maximum(&strengths.1);
        // An event remembers, or may come to: its flag is never shared, though its strengths are.
        let to = self.new_bool();
        let hysteresis = event.hysteresis.to_f64();
        self.code.steps.push(if event.hysteresis.is_zero() {
            Step::Outweighs { contributor, detractor, to }
        } else {
            let memory = next(&mut self.code.memories);
            Step::OutweighsWithHysteresis { contributor, detractor, hysteresis, memory, to }
        });
        let mut flag = to;
        if event.confirm > 0 {
            let (of, to, stopwatch) = (flag, self.new_bool(), next(&mut self.code.stopwatches));
            self.code.steps.push(Step::Lasts { of, duration: event.confirm, stopwatch, to });
            flag = to;
        }
        if event.hold > 0 {
            let (of, to, stopwatch) = (flag, self.new_bool(), next(&mut self.code.stopwatches));
            self.code.steps.push(Step::Hold { of, duration: event.hold, stopwatch, to });
            flag = to;
        }
        EventSlots { contributor, detractor, flag, strengths }
    }

    /// Rows with `_` and sets stay factored: the minimum over inputs of the maximum over terms.
    fn strength(&mut self, rule: &ir::Rule, inputs: &[ir::NetworkInput], readings: &[Real]) -> Real {
        let clauses = rule.clauses.iter().map(|clause| self.clause(clause, inputs, readings));
        let clauses: Vec<_> = clauses.collect();
        self.minimum(&clauses)
    }

    pub(super) fn clause(&mut self, clause: &ir::Clause, inputs: &[ir::NetworkInput], readings: &[Real]) -> Real {
        let (reading, variable) = (readings[clause.input as usize], inputs[clause.input as usize].variable);
        let degrees = clause.any_of.iter().map(|literal| {
            let degree = self.degree(reading, variable, literal.term);
            if literal.negated { self.complement(degree) } else { degree }
        });
        let degrees: Vec<_> = degrees.collect();
        self.maximum(&degrees)
    }

    /// The value of a condition or operand, emitted where it is not known yet.
    pub(super) fn expr(&mut self, root: Id<ir::Expr>, names: &Names<'_>) -> u32 {
        let mut values: HashMap<Id<ir::Expr>, u32> = HashMap::new();
        for id in reachable(self.program, root) {
            let value = self.operation(&self.program.exprs[id].op, &values, names);
            values.insert(id, value);
        }
        values[&root]
    }

    fn operation(&mut self, op: &ir::Op, values: &HashMap<Id<ir::Expr>, u32>, names: &Names<'_>) -> u32 {
        match op {
            // A checked program has no poison, and nothing unknown; false is as good as anything.
            ir::Op::Error | ir::Op::Unknown => self.bool(Key::Any(Vec::new()), |_, to| Step::Any { of: 0..0, to }),
            ir::Op::Number(value) => self.constant(value.to_f64()),
            ir::Op::Sensor(sensor) => self.sensor(*sensor, names.platform, names.logical),
            ir::Op::Failed(sensor) => match names.platform.feed(*sensor) {
                Feed::Input(input) => self.failed(input),
                Feed::Logical(place) => {
                    let of = names.logical[place as usize].of.iter();
                    let failed: Vec<_> = of.map(|&input| self.failed(input)).collect();
                    self.any(&failed)
                }
            },
            ir::Op::Event { sense, event } => names.events[*sense as usize][*event as usize],
            ir::Op::Flag(flag) => names.flags[flag.index()],
            ir::Op::InMode(mode) => {
                let mode = mode.index() as u32;
                self.bool(Key::InMode(mode), |_, to| Step::InMode { mode, to })
            }
            ir::Op::Inside(path) => {
                let path: Vec<_> = path.iter().map(|mode| mode.index() as u32).collect();
                let key = Key::Inside(path.clone());
                self.bool(key, |code, to| Step::Inside { path: list(&mut code.paths, &path), to })
            }
            &ir::Op::After(duration) => self.bool(Key::After(duration), |_, to| Step::After { duration, to }),
            ir::Op::Done => self.bool(Key::Done, |_, to| Step::Done { to }),
            ir::Op::Count(of) => {
                let of = values[of];
                self.real(Key::Count(of), |code, to| {
                    let (memory, counter) = (next(&mut code.memories), next(&mut code.counters));
                    Step::Count { of, memory, counter, to }
                })
            }
            ir::Op::Rising(of) => {
                let of = values[of];
                self.bool(Key::Rising(of), |code, to| Step::Rising { of, memory: next(&mut code.memories), to })
            }
            ir::Op::Falling(of) => {
                let of = values[of];
                self.bool(Key::Falling(of), |code, to| Step::Falling { of, memory: next(&mut code.memories), to })
            }
            ir::Op::Latched(of) => {
                let of = values[of];
                self.bool(Key::Latched(of), |code, to| Step::Latched { of, latch: next(&mut code.latches), to })
            }
            ir::Op::Held(of, duration) => {
                let (of, duration) = (values[of], *duration);
                self.bool(Key::Held(of, duration), |code, to| Step::Lasts {
                    of,
                    duration,
                    stopwatch: next(&mut code.stopwatches),
                    to,
                })
            }
            // A contact is only ever compared to learn whether it is set.
            ir::Op::Compare(_, contact, _) if names.is_condition(&self.program.exprs[*contact].op) => values[contact],
            ir::Op::Compare(comparison, left, right) => {
                let (left, right) = (values[left], values[right]);
                self.bool(Key::Compare(*comparison, left, right), |_, to| Step::Compare {
                    comparison: *comparison,
                    left,
                    right,
                    to,
                })
            }
            ir::Op::Not(of) => {
                let of = values[of];
                self.bool(Key::Not(of), |_, to| Step::Not { of, to })
            }
            ir::Op::And(operands) => {
                let of: Vec<_> = operands.iter().map(|operand| values[operand]).collect();
                self.bool(Key::All(of.clone()), |code, to| Step::All { of: list(&mut code.bool_lists, &of), to })
            }
            ir::Op::Or(operands) => self.any(&operands.iter().map(|operand| values[operand]).collect::<Vec<_>>()),
        }
    }
}

/// An expression and everything it is made of, operands first: ids ascend from operands to what uses them.
pub(super) fn reachable(program: &ir::Program, root: Id<ir::Expr>) -> Vec<Id<ir::Expr>> {
    let mut found = vec![root];
    let mut next = 0;
    while let Some(&id) = found.get(next) {
        next += 1;
        found.extend(program.exprs[id].op.operands());
    }
    found.sort_unstable();
    found
}

fn next(count: &mut u32) -> u32 {
    *count += 1;
    *count - 1
}

pub(super) fn list(lists: &mut Vec<u32>, of: &[u32]) -> Range<u32> {
    let start = lists.len() as u32;
    lists.extend(of);
    start..lists.len() as u32
}

fn lower_shape(shape: &ir::Shape, code: &mut Code) -> Shape {
    match shape {
        ir::Shape::Triangle(corners) => Shape::Triangle(corners.map(Exact::to_f64)),
        ir::Shape::Trapezoid(corners) => Shape::Trapezoid(corners.map(Exact::to_f64)),
        ir::Shape::Ramp { zero_at, one_at } => Shape::Ramp { zero_at: zero_at.to_f64(), one_at: one_at.to_f64() },
        ir::Shape::Rectangle(ends) => Shape::Rectangle(ends.map(Exact::to_f64)),
        ir::Shape::Singleton(at) => Shape::Singleton(at.to_f64()),
        ir::Shape::Points(points) => {
            let start = code.points.len() as u32;
            code.points.extend(points.iter().map(|(at, degree)| (at.to_f64(), degree.to_f64())));
            Shape::Points(start..code.points.len() as u32)
        }
        ir::Shape::Gaussian(of) => Shape::Gaussian(of.map(Exact::to_f64)),
        ir::Shape::Gaussian2(of) => Shape::Gaussian2(of.map(Exact::to_f64)),
        ir::Shape::Bell(of) => Shape::Bell(of.map(Exact::to_f64)),
        ir::Shape::Sigmoid(of) => Shape::Sigmoid(of.map(Exact::to_f64)),
        ir::Shape::Rise(of) => Shape::Rise(of.map(Exact::to_f64)),
        ir::Shape::Fall(of) => Shape::Fall(of.map(Exact::to_f64)),
        ir::Shape::RiseAndFall(of) => Shape::RiseAndFall(of.map(Exact::to_f64)),
        ir::Shape::Cosine(of) => Shape::Cosine(of.map(Exact::to_f64)),
        // Taken apart before; a part of it is never built itself.
        ir::Shape::Built(_) => Shape::Points(0..0),
    }
}
