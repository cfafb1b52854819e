//! Random programs that use the whole language, for comparing what runs them.

use std::fmt::Write;

use lmslc::kernel::next_random;

/// A seeded source of choices.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, limit: u64) -> u64 {
        next_random(&mut self.0) % limit
    }

    pub fn one_of<T: Clone>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u64) as usize].clone()
    }

    pub fn chance(&mut self, one_in: u64) -> bool {
        self.below(one_in) == 0
    }

    /// Some corners from 0 to 10, ascending, in quarters; now and then two are equal.
    fn corners(&mut self, count: usize) -> Vec<f64> {
        let mut corners: Vec<f64> = (0..count).map(|_| self.below(41) as f64 / 4.0).collect();
        corners.sort_by(f64::total_cmp);
        if corners[0] == corners[count - 1] {
            return (0..count).map(|corner| corner as f64 * 2.5).collect();
        }
        corners
    }

    /// The shape of a term; the terms before it are called `t` and their number.
    pub fn shape(&mut self, before: u64, smooth: bool) -> String {
        if smooth && self.chance(2) {
            return self.smooth_shape(before);
        }
        let kind =
            self.one_of(&["ramp", "ramp", "triangle", "triangle", "trapezoid", "rectangle", "points", "singleton"]);
        let list = |corners: &[f64]| corners.iter().map(|corner| format!("{corner}")).collect::<Vec<_>>().join(", ");
        match kind {
            "ramp" => {
                let mut ends = self.corners(2);
                if self.chance(2) {
                    ends.reverse();
                }
                format!("ramp({})", list(&ends))
            }
            "triangle" => format!("triangle({})", list(&self.corners(3))),
            "trapezoid" => format!("trapezoid({})", list(&self.corners(4))),
            "rectangle" => format!("rectangle({})", list(&self.corners(2))),
            "singleton" => format!("singleton({})", self.below(11)),
            _ => {
                let corners = self.corners(4);
                let points = corners.iter().map(|corner| format!("({corner}, {})", self.below(5) as f64 / 4.0));
                format!("points({})", points.collect::<Vec<_>>().join(", "))
            }
        }
    }

    fn smooth_shape(&mut self, before: u64) -> String {
        let (at, width) = (1 + self.below(9), 1 + self.below(4));
        let corners = self.corners(4);
        let mut shapes = vec![
            format!("gaussian({at}, {width})"),
            format!("gaussian2({at}, {width}, 9.5, 0.5)"),
            format!("bell({at}, {width}, 2.5)"),
            format!("sigmoid({at}, -{width})"),
            format!("s_shape({}, {})", corners[0], corners[3]),
            format!("z_shape({}, {})", corners[0], corners[3]),
            format!("pi_shape({}, {}, {}, {})", corners[0], corners[1], corners[2], corners[3]),
            format!("cosine({at}, {width})"),
        ];
        if before > 0 {
            let (one, other) = (self.below(before), self.below(before));
            let built = ["not t#", "very t#", "somewhat t#", "t# or t?", "t# and not t?", "very (t# or not t?)"];
            let named = |built: &str| built.replace('#', &one.to_string()).replace('?', &other.to_string());
            shapes.extend(built.map(named));
        }
        self.one_of(&shapes)
    }

    fn fails(&mut self) -> String {
        let value = self.below(11);
        self.one_of(&[
            String::new(),
            format!("fails {value}"),
            format!("fails any, {value}"),
            "fails absent".to_owned(),
        ])
    }
}

/// A term of a variable is called `t` and its position, a variable `v`, an event of the network `n` `n_e` and its
/// position, and so on: every name says what it is.
struct Program {
    random: Random,
    /// Whether terms may be smooth, or built from others.
    smooth: bool,
    /// Whether the behavior may draw random numbers.
    draws: bool,
    /// How many terms each variable has.
    terms: Vec<u64>,
    /// The variables of each network's inputs, and how many events it has.
    networks: Vec<(Vec<usize>, u64)>,
    /// The outputs that a behavior can name.
    outputs: Vec<String>,
    /// The inputs of sensed networks that a behavior can name: the name, how many terms it has, and what these are of.
    inputs: Vec<(String, u64, String)>,
    /// The modes of the diagrams that the one that is written runs: `m1.mode is m2` of all of them.
    inner: Vec<String>,
    /// Whether what the mode that is written does can complete.
    completes: bool,
}

/// The text of a `.fsfn` file and of a `.msd` file that imports it as `n`. The behavior is called `b`; every third
/// program has another one, `c`, an activity `t` that runs both, and a goal `g` that runs the activity; every 25th an
/// arbiter, `r`, with its clients. Programs of odd numbers have outputs.
pub fn program(seed: u64) -> (String, String) {
    let (smooth, draws) = (seed.is_multiple_of(3), !seed.is_multiple_of(4));
    let (terms, networks, outputs, inputs, inner) = Default::default();
    let random = Random(seed);
    let mut program = Program { random, smooth, draws, terms, networks, outputs, inputs, inner, completes: true };
    let fusion = program.fusion(seed % 2 == 1);
    let is_arbitrated = seed % 25 == 2;
    let mut modes = program.robot(is_arbitrated) + &program.diagram("behavior b", &[]);
    if seed % 3 == 1 {
        modes += &program.diagram("behavior c", &[]);
        modes += &program.diagram("activity t", &["b", "c"]);
        modes += &program.diagram("goal g", &["t", "t", "c"]);
    }
    if is_arbitrated {
        modes += &program.diagram("behavior client_one", &[]);
        modes += &program.diagram("behavior client_two", &[]);
        modes += &program.arbiter(&["client_one", "client_two", "client_one"]);
    }
    (fusion, modes)
}

const SENSORS: usize = 4;

const DRIVE: &str =
    "behavior cart_drive on cart { entry idle  mode idle { brake()  1: command is turn and c -> idle_too }
    mode idle_too { brake()  1: after 1 s -> idle } }\n";

/// What feeds networks and is compared: sensors, elements of an array, logical sensors.
const READINGS: [&str; 12] =
    ["s0", "s1", "s2", "s3", "a[0]", "a[2]", "nearest", "middle", "average", "steady", "exact", "slow"];

/// What is true or false without any network.
const CONTACTS: [&str; 5] = ["c", "b[0]", "b[1]", "touched", "held"];

impl Program {
    fn fusion(&mut self, has_outputs: bool) -> String {
        let mut text = String::new();
        for variable in 0..=self.random.below(3) {
            let terms = 2 + self.random.below(3);
            writeln!(text, "variable v{variable}: 1 in 0 .. 10 {} {{", self.random.fails()).unwrap();
            for term in 0..terms {
                let shape = self.random.shape(term, self.smooth);
                writeln!(text, "    t{term} = {shape}").unwrap();
            }
            text += "}\n";
            self.terms.push(terms);
        }
        for network in 0..=self.random.below(2) {
            let count = 1 + self.random.below(3);
            let inputs: Vec<usize> = (0..count).map(|_| self.random.below(self.terms.len() as u64) as usize).collect();
            let declared = inputs.iter().enumerate().map(|(input, variable)| format!("i{input}: v{variable}"));
            let declared = declared.collect::<Vec<_>>().join(", ");
            let inference = if has_outputs { self.inference() } else { String::new() };
            writeln!(text, "/// Network number {network}.\nnetwork n{network}({declared}){inference} {{").unwrap();
            let events = if has_outputs && self.random.chance(3) { 0 } else { 1 + self.random.below(3) };
            for event in 0..events {
                text += &self.event(network, event, &inputs);
            }
            if has_outputs {
                for output in 0..=self.random.below(3) {
                    text += &self.output(network, output, &inputs);
                }
            }
            text += "}\n";
            self.networks.push((inputs, events));
        }
        text
    }

    fn event(&mut self, network: u64, event: u64, inputs: &[usize]) -> String {
        let mut options = String::new();
        for option in ["hysteresis 0.15", "confirm 30 ms", "hold 70 ms"] {
            if self.random.chance(5) {
                options = format!("{options} {option}");
            }
        }
        let mut text = format!("    event n{network}_e{event}{options} {{\n");
        for (side, least) in [("contributor", 1), ("detractor", 0)] {
            let rules = least + self.random.below(7);
            if rules > 0 {
                writeln!(text, "        {side}").unwrap();
            }
            for _ in 0..rules {
                let rule = if self.random.chance(4) { self.rule_in_words(inputs) } else { self.row(inputs) };
                writeln!(text, "            {rule}").unwrap();
            }
        }
        text + "    }\n"
    }

    fn inference(&mut self) -> String {
        let norms = ["product", "bounded_difference", "drastic_product", "einstein_product", "hamacher_product"];
        let and =
            self.random.one_of(&[["min"; 5], norms, ["min", "nilpotent_minimum", "min", "product", "min"]].concat());
        let sums = ["probabilistic_sum", "bounded_sum", "drastic_sum", "einstein_sum", "hamacher_sum"];
        let or =
            self.random.one_of(&[["max"; 5], sums, ["max", "nilpotent_maximum", "max", "drastic_sum", "max"]].concat());
        let (implication, aggregation) = (self.random.one_of(&["min", "product"]), self.random.one_of(&["max", "sum"]));
        let defuzzify = self.random.one_of(&[
            "centroid",
            "centroid",
            "centroid",
            "centroid midpoints 7",
            "bisector",
            "smallest_of_maximum",
            "largest_of_maximum",
            "mean_of_maximum",
            "weighted_average",
        ]);
        format!(
            " using {{ and {and}, or {or}, implication {implication}, aggregation {aggregation}, defuzzify {defuzzify} }}"
        )
    }

    fn output(&mut self, network: u64, output: u64, inputs: &[usize]) -> String {
        let name = format!("n{network}_o{output}");
        self.outputs.extend([format!("n{network}.{name}"), format!("again_n{network}.{name}")]);
        let rest = self.random.one_of(&["default 3", "default hold", "default hold", ""]);
        let range = self.random.one_of(&["-2 .. 8", "0 .. 10", "1 .. 9"]);
        let is_linear = self.random.chance(5);
        let sets = 2 + self.random.below(3);
        let mut text = if is_linear {
            let range = self.random.one_of(&["", " in 0 .. 5"]);
            format!("    output {name}: 1{range} {rest} = takagi_sugeno\n")
        } else {
            let sets = (0..sets).map(|set| format!("s{set} = {}\n", self.random.shape(0, false)));
            format!("    output {name}: 1 in {range} {rest} {{\n{}    }}\n", sets.collect::<Vec<_>>().concat())
        };
        for rule in 0..=sets + self.random.below(4) {
            let mut test = || {
                let input = self.random.below(inputs.len() as u64) as usize;
                let terms = self.terms[inputs[input]];
                let term = self.random.below(terms);
                let terms =
                    self.random.one_of(&[format!("t{term}"), format!("not t{term}"), "any of {t0, t1}".to_owned()]);
                match terms.strip_prefix("not ") {
                    Some(term) => format!("not i{input} is {term}"),
                    None => format!("i{input} is {terms}"),
                }
            };
            let (one, two, three) = (test(), test(), test());
            let condition = self.random.one_of(&[
                one.clone(),
                format!("{one} and {two}"),
                format!("{one} and ({two} or {three})"),
                format!("not ({one} and {two}) or {three}"),
            ]);
            let input = self.random.below(inputs.len() as u64);
            let value = if is_linear {
                let linear = [&format!("= i{input} * 0.5 - i0 + 2"), "= 4", &format!("= -i{input} / 3")];
                self.random.one_of(&linear.map(str::to_owned))
            } else {
                format!("is s{}", rule % sets)
            };
            let weight = self.random.one_of(&["", "", " weight 0.8"]);
            writeln!(text, "    rule {condition} => {name} {value}{weight}").unwrap();
        }
        text
    }

    fn row(&mut self, inputs: &[usize]) -> String {
        let cells = inputs.iter().map(|&variable| {
            let terms = self.terms[variable];
            match self.random.below(8) {
                0 => "_".to_owned(),
                1 => "-".to_owned(),
                2 => format!("{{t0, t{}}}", 1 + self.random.below(terms - 1)),
                _ => format!("t{}", self.random.below(terms)),
            }
        });
        format!("({})", cells.collect::<Vec<_>>().join(", "))
    }

    fn rule_in_words(&mut self, inputs: &[usize]) -> String {
        let mut test = || {
            let input = self.random.below(inputs.len() as u64) as usize;
            let term = self.random.below(self.terms[inputs[input]]);
            let not = self.random.one_of(&["", "", "not "]);
            format!("{not}i{input} is t{term}")
        };
        let tests = [test(), test(), test()];
        let words = self.random.one_of(&["and", "or"]);
        format!("rule {} {words} ({} or {})", tests[0], tests[1], tests[2])
    }

    fn atom(&mut self) -> String {
        let network = self.random.below(self.networks.len() as u64);
        let events = self.networks[network as usize].1;
        if events == 0 {
            return format!("s0 < {}", 1 + self.random.below(9));
        }
        let event = self.random.below(events);
        let sense = self.random.one_of(&["n", "n", "again_n"]);
        let event = format!("{sense}{network}.n{network}_e{event}");
        let (reading, other) = (self.random.one_of(&READINGS), self.random.one_of(&READINGS));
        let operator = self.random.one_of(&["<", "<=", ">", ">=", "==", "!="]);
        if !self.inner.is_empty() && self.random.chance(3) {
            return self.random.one_of(&self.inner);
        }
        match self.random.below(9) {
            0 => format!("{reading} {operator} {}", 1 + self.random.below(9)),
            1 => format!("{reading} {operator} {other}"),
            2 => format!("failed({})", self.random.one_of(&[reading, "a", "a[0..1]", "c", "held"])),
            3 if self.completes => "done".to_owned(),
            4 => self.random.one_of(&CONTACTS).to_owned(),
            5 if !self.smooth => self.is_term(),
            _ => event,
        }
    }

    fn is_term(&mut self) -> String {
        let (input, terms, _) = self.random.one_of(&self.inputs);
        let term = self.random.below(terms);
        let terms = self.random.one_of(&[format!("t{term}"), format!("any of {{t0, t{term}}}")]);
        format!("{input} is {terms}")
    }

    /// A decision table with one row for every case.
    fn table(&mut self, flags: u64) -> String {
        let (mut columns, mut known, mut rows) = (Vec::new(), Vec::new(), vec![Vec::new()]);
        for _ in 0..=self.random.below(3) {
            let (column, values) = match self.random.below(5) {
                0 if flags > 0 => (format!("f{}", self.random.below(flags)), None),
                1 => (format!("failed({})", self.random.one_of(&READINGS)), None),
                2 if !self.smooth => (self.is_term(), None),
                3 => (self.random.one_of(&CONTACTS).to_owned(), None),
                _ if self.smooth => (self.random.one_of(&CONTACTS).to_owned(), None),
                _ => {
                    let (input, terms, of) = self.random.one_of(&self.inputs);
                    if known.contains(&of) {
                        continue;
                    }
                    known.push(of);
                    (input, Some(terms))
                }
            };
            if columns.contains(&column) {
                continue;
            }
            let values = match values {
                None => vec!["set".to_owned(), "clear".to_owned()],
                Some(terms) => (0..terms).map(|term| format!("t{term}")).collect(),
            };
            columns.push(column);
            let split = |row: Vec<String>, random: &mut Random| -> Vec<Vec<String>> {
                let cut = random.below(values.len() as u64) as usize;
                let cells = match cut {
                    0 => vec![random.one_of(&["_", "-"]).to_owned()],
                    _ => [&values[..cut], &values[cut..]].map(|values| format!("{{{}}}", values.join(", "))).to_vec(),
                };
                cells.into_iter().map(|cell| [row.clone(), vec![cell]].concat()).collect()
            };
            rows = rows.into_iter().flat_map(|row| split(row, &mut self.random)).collect();
        }
        let mut text = format!(
            "        decide ({}) {{
",
            columns.join(", ")
        );
        for row in rows {
            let (first, second) = (self.call(), self.call());
            let command = match self.random.below(4) {
                0 => "nothing".to_owned(),
                1 if self.draws => format!("either({first}, {second}, halt())"),
                _ => first,
            };
            writeln!(text, "            ({}) => {command}", row.join(", ")).unwrap();
        }
        text + "        }
"
    }

    fn condition(&mut self, flags: u64) -> String {
        let flag = |random: &mut Random, atom: String| {
            if flags > 0 && random.chance(2) { format!("f{}", random.below(flags)) } else { atom }
        };
        let atom = self.atom();
        let plain = flag(&mut self.random, atom);
        let duration = 10 * (1 + self.random.below(12));
        let mut condition = match self.random.below(12) {
            0 => format!("rising({plain})"),
            1 => format!("falling({plain})"),
            2 => format!("held({plain}, {duration} ms)"),
            3 => format!("latched({plain})"),
            4 => format!("count({plain}) >= {}", 1 + self.random.below(3)),
            5 => format!("after {duration} ms"),
            6 => format!("not {plain}"),
            7 => self.random.one_of(&[
                format!("rising(latched({plain}))"),
                format!("held(after {duration} ms, 50 ms)"),
                format!("latched(count({plain}) >= 2)"),
                format!("falling(not held({plain}, 20 ms) or s0 > 5)"),
                "after 5 s".to_owned(),
                "count(s0 > 5) != count(s1 > 5)".to_owned(),
            ]),
            _ => plain,
        };
        for _ in 0..self.random.below(3) {
            let (word, atom) = (self.random.one_of(&["and", "or", "and not", "or not"]), self.atom());
            condition = format!("({condition}) {word} {}", flag(&mut self.random, atom));
        }
        condition
    }

    fn call(&mut self) -> String {
        let calls = [
            "halt()",
            "drive(26 cm/s)",
            "turn(90 deg)",
            "turn(random(-120 deg, 120 deg))",
            "arc(-0.1 m/s, radius: random(1 m, 3 m))",
        ];
        if !self.outputs.is_empty() && self.random.chance(2) {
            return format!("to_ring({})", self.random.one_of(&self.outputs));
        }
        self.random.one_of(if self.draws { &calls } else { &calls[..3] }).to_owned()
    }

    /// Where behaviors share it, its commands are carried out by one of its own: only then do they see who won.
    fn robot(&mut self, is_arbitrated: bool) -> String {
        let (runs, drive) = if is_arbitrated { (" runs cart_drive", DRIVE) } else { ("", "") };
        let mut text = format!("import n\n{drive}robot cart{runs} {{\n");
        for sensor in 0..SENSORS {
            let optional = if sensor > 1 { "optional " } else { "" };
            let range = self.random.one_of(&["0 .. 10", "-2 .. 12", "1 .. 9"]);
            let fails = self.random.one_of(&["", "fails 3", "fails 8, any"]);
            let rate = "accuracy 0.5 period 25 ms";
            writeln!(text, "    {optional}sensor s{sensor}: 1 in {range} {fails} {rate}").unwrap();
        }
        text += "    sensor a[3]: 1 in 0 .. 10 fails 4 accuracy 2 period 20 ms\n    sensor b[2]: contact fails set\n    sensor c: contact
    logical nearest = min(a, s0)\n    logical farthest = max(a[1..2])\n    logical average = mean(a, s1, s2)
    logical middle = median(s0, s1, a)\n    logical between = median(a[0, 2])\n    logical touched = any(b, c)
    logical held = all(b)\n    logical steady = s0 within 60 ms\n    logical exact = min(a, s1) within 1
    logical slow = median(a[0], s0, s2) within 80 ms\n";
        if is_arbitrated {
            text += "    body differential_drive { mass 20 kg  size (0.6 m, 0.5 m)  track 0.4 m  traction 0.5 }\n";
            text += "    action brake() = body.stop()\n";
        }
        text += "    action halt()\n    action drive(speed: m/s)\n    action arc(speed: m/s, radius: m)
    action turn(angle: deg) -> done\n    action to_ring(times: 1)\n}\n";
        text
    }

    /// A diagram whose modes run others, or give commands where there are none.
    fn diagram(&mut self, title: &str, inner: &[&str]) -> String {
        let mut text = format!("{title} on cart {{\n");
        self.inputs.clear();
        if inner.is_empty() {
            self.inner.clear();
        }
        for network in 0..self.networks.len() {
            for name in ["", "again_"] {
                let variables = self.networks[network].0.clone();
                let known = [READINGS.as_slice(), &["farthest", "between"]].concat();
                let feeds: Vec<_> = variables.iter().map(|_| self.random.one_of(&known)).collect();
                writeln!(text, "    sense {name}n{network} = n{network}({})", feeds.join(", ")).unwrap();
                for (input, (variable, feed)) in variables.into_iter().zip(feeds).enumerate() {
                    let of = format!("{feed} as v{variable}");
                    self.inputs.push((format!("{name}n{network}.i{input}"), self.terms[variable], of));
                }
            }
        }
        let flags = self.random.below(4);
        for flag in 0..flags {
            writeln!(text, "    flag f{flag} = {}", self.condition(flag)).unwrap();
        }
        let modes = if inner.is_empty() { 2 + self.random.below(5) } else { inner.len() as u64 };
        // Every diagram has two modes at least.
        self.inner = (0..inner.len()).map(|mode| format!("m{mode}.mode is any of {{m0, m1}}")).collect();
        self.inner.extend((0..inner.len()).map(|mode| format!("m{mode}.mode is m1")));
        if inner.contains(&"t") {
            self.inner.push("m0.m1.mode is m0".to_owned());
        }
        text += "    entry m0\n";
        for mode in 0..modes {
            let requires = match self.random.below(4) {
                0 if mode > 0 => format!(" requires s2 else m{}", self.random.below(mode)),
                1 if mode > 0 => " requires s2, s3".to_owned(),
                _ => String::new(),
            };
            let turn = if self.draws { "turn(random(-1 rad, 1 rad))" } else { "turn(1 rad)" };
            match inner.get(mode as usize) {
                Some(inner) => {
                    let resume = self.random.one_of(&["", " resume"]);
                    writeln!(text, "    mode m{mode} = {inner}{resume}{requires} {{").unwrap();
                }
                None => writeln!(text, "    mode m{mode}{requires} {{").unwrap(),
            }
            // A client gives one command on a tick.
            let is_client = title.starts_with("behavior client");
            let decides = inner.is_empty() && self.random.chance(2);
            let mut turns = !is_client;
            if inner.is_empty() && !(is_client && decides) {
                let command = if is_client { self.call() } else { turn.to_owned() };
                turns |= command.starts_with("turn");
                writeln!(text, "        {command}").unwrap();
            }
            let whens: &[&str] = if inner.is_empty() { &["on enter", "on exit", ""] } else { &["on enter", "on exit"] };
            for &when in whens.iter().filter(|_| !is_client) {
                if self.random.chance(3) {
                    let (first, second) = (self.call(), self.random.one_of(&["to_ring(2)", "halt()"]));
                    let calls = if when.is_empty() { first } else { format!("{when} {{ {first}  {second} }}") };
                    writeln!(text, "        {calls}").unwrap();
                }
            }
            if decides {
                text += &self.table(flags);
            }
            self.completes = inner.get(mode as usize).map_or(turns, |inner| *inner == "c");
            for priority in 1..=1 + self.random.below(4) {
                let target = self.random.below(modes);
                let target = if target == mode { "again".to_owned() } else { format!("m{target}") };
                writeln!(text, "        {priority}: {} -> {target}", self.condition(flags)).unwrap();
            }
            if title == "behavior c" {
                text += "        9: after 130 ms -> end\n";
            }
            if is_client {
                let outcome = self.random.one_of(&["won", "lost", "held(lost, 20 ms)", "not won and lost"]);
                writeln!(text, "        9: {outcome} and {} -> m{}", self.atom(), self.random.below(modes)).unwrap();
            }
            text += "    }\n";
        }
        self.completes = true;
        if title == "behavior c" {
            text += "    final mode end { halt() }\n";
        }
        text + "}\n"
    }

    /// An arbiter of some clients.
    fn arbiter(&mut self, clients: &[&str]) -> String {
        let mut text =
            format!("arbiter r on cart {{\n    ties {}\n", self.random.one_of(&["in_order", "random", "random"]));
        let mut condition = || {
            let contact = self.random.one_of(&CONTACTS);
            let reading = self.random.one_of(&READINGS);
            self.random.one_of(&[
                contact.to_owned(),
                format!("{reading} > 6"),
                format!("rising({contact})"),
                format!("held({reading} > 3, 40 ms)"),
                format!("latched({contact}) and {reading} > 4"),
                format!("count({contact}) >= 2"),
                "after 50 ms".to_owned(),
                "failed(s1)".to_owned(),
            ])
        };
        let conditions: Vec<_> = (0..3 + clients.len()).map(|_| condition()).collect();
        let (bypass, levels) = conditions.split_at(self.random.below(4) as usize);
        for condition in bypass {
            writeln!(text, "    emergency {condition} and not c -> brake()").unwrap();
        }
        for ((place, client), condition) in clients.iter().enumerate().zip(levels) {
            let level = 1 + self.random.below(3);
            let rest = self.random.one_of(&["", " else 2", " else 3"]);
            let when = if self.random.chance(2) { format!(" when {condition}{rest}") } else { String::new() };
            writeln!(text, "    client p{place} = {client} priority {level}{when}").unwrap();
        }
        text + "}\n"
    }
}
