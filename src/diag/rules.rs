//! The registry of rules: every code a finding can have, and its explain page.

use super::Severity;

/// One kind of finding.
#[derive(Debug, PartialEq, Eq)]
pub struct Rule {
    /// `LM` and four digits; the first two name the subject. Never reused.
    pub code: &'static str,
    /// The name for configuration and reports.
    pub name: &'static str,
    /// One line for lists.
    pub summary: &'static str,
    /// Its level unless configured otherwise.
    pub level: Severity,
    /// The version that introduced it.
    pub since: &'static str,
    /// Its explain page, Markdown.
    pub page: &'static str,
}

impl Rule {
    /// Whether it is about what failed sensors do.
    pub fn is_about_faults(&self) -> bool {
        self.code.starts_with("LM06")
    }
}

/// The rule with that code or name, in any case.
pub fn find_rule(code_or_name: &str) -> Option<&'static Rule> {
    RULES
        .iter()
        .copied()
        .find(|rule| rule.code.eq_ignore_ascii_case(code_or_name) || rule.name.eq_ignore_ascii_case(code_or_name))
}

/// All codes and names, to look for what was meant.
pub fn names() -> impl Iterator<Item = &'static str> {
    RULES.iter().flat_map(|rule| [rule.code, rule.name])
}

macro_rules! rules {
    ($($constant:ident $code:literal $name:literal $level:ident $summary:literal)*) => {
        $(
            #[doc = $summary]
            pub static $constant: Rule = Rule {
                code: $code,
                name: $name,
                summary: $summary,
                level: Severity::$level,
                since: "0.1.0",
                page: include_str!(concat!("../../docs/errors/", $code, ".md")),
            };
        )*
        /// Every rule, by code.
        pub static RULES: &[&Rule] = &[$(&$constant),*];
    };
}

rules! {
    UNREADABLE_FILE "LM0001" "unreadable-file" Error "a file cannot be read"
    NOT_UTF8 "LM0002" "not-utf8" Error "a file is not UTF-8 text"
    MISSING_IMPORT "LM0003" "missing-import" Error "an import names no file"
    IMPORT_CYCLE "LM0004" "import-cycle" Error "files import each other in a circle"
    UNKNOWN_FILE_KIND "LM0005" "unknown-file-kind" Error "a file's name ends neither in .msd nor in .fsfn"
    AMBIGUOUS_IMPORT "LM0006" "ambiguous-import" Error "an import names two files"
    FILE_TOO_LARGE "LM0007" "file-too-large" Error "a file is larger than the compiler takes"
    BAD_CONFIGURATION "LM0008" "bad-configuration" Error "lmsl.toml says something the compiler does not know"
    BAD_SUPPRESSION "LM0009" "bad-suppression" Warning "a comment that cannot suppress what it names"
    UNUSED_SUPPRESSION "LM0010" "unused-suppression" Warning "a comment that suppresses nothing"

    SYNTAX_ERROR "LM0101" "syntax-error" Error "text that is not part of the language"
    TOO_DEEP "LM0102" "nesting-too-deep" Error "parentheses nested deeper than the compiler takes"
    KEYWORD_AS_NAME "LM0103" "keyword-as-name" Error "a keyword used as a name"
    WRONG_FILE_KIND "LM0104" "wrong-file-kind" Error "a declaration that belongs in the other kind of file"
    NOT_SUPPORTED "LM0105" "not-supported-yet" Error "a construct this version reads but cannot run yet"

    UNKNOWN_NAME "LM0201" "unknown-name" Error "a name that is declared nowhere"
    DUPLICATE_NAME "LM0202" "duplicate-name" Error "one name declared twice"
    NAME_CLASH "LM0203" "name-clash" Error "one name brought into scope from two files"
    WRONG_KIND "LM0204" "wrong-kind-of-name" Error "a name of one kind where another is needed"
    CIRCULAR "LM0205" "circular-declaration" Error "declarations that need each other in a circle"
    AMBIGUOUS_NAME "LM0206" "ambiguous-name" Error "a name that could mean two things"
    UNUSED_IMPORT "LM0207" "unused-import" Warning "an import of which nothing is used"
    UNUSED_FLAG "LM0208" "unused-flag" Warning "a flag that nothing reads"
    UNUSED_SENSE "LM0209" "unused-sense" Warning "a sensed network of which no event is read"
    UNUSED_TERM "LM0210" "unused-term" Warning "a term that no rule names"
    UNUSED_VARIABLE "LM0211" "unused-variable" Warning "a variable that no network takes"
    UNUSED_SENSOR "LM0212" "unused-sensor" Info "a sensor that nothing reads"

    DIMENSION_MISMATCH "LM0301" "dimension-mismatch" Error "a quantity of the wrong dimension"
    UNKNOWN_UNIT "LM0302" "unknown-unit" Error "a unit the language does not know"
    MISSING_UNIT "LM0303" "missing-unit" Error "a number without the unit it needs"
    NUMBER_TOO_LONG "LM0304" "number-too-long" Error "a number with more digits than can be kept exactly"
    OUTSIDE_RANGE "LM0305" "outside-range" Warning "a literal outside the declared range"
    NOT_A_CONDITION "LM0306" "not-a-condition" Error "a value where something true or false is needed"
    WRONG_ARGUMENTS "LM0307" "wrong-arguments" Error "arguments that do not fit the parameters"
    EMPTY_RANGE "LM0308" "empty-range" Error "a range whose lower end is not below its upper end"
    INVALID_VALUE "LM0309" "invalid-value" Error "a number that this place cannot take"
    TWICE "LM0310" "said-twice" Error "something that may be said once is said twice"
    MISSING_PART "LM0311" "missing-part" Error "a declaration lacks a part it needs"
    INTERFACE_NOT_KEPT "LM0312" "interface-not-kept" Error "a robot does not keep what its interface promises"

    DONE_NEVER_REPORTED "LM0313" "done-never-reported" Error "`done` in a mode whose actions never report completion"
    BELOW_TICK "LM0314" "below-tick" Warning "a time shorter than a tick"
    BETWEEN_TICKS "LM0315" "between-ticks" Info "a time that is not a whole number of ticks"
    LOGICAL_LOOKS_BACK "LM0316" "logical-looks-back" Error "a logical sensor whose condition looks back in time"

    MISSING_ENTRY "LM0401" "missing-entry" Error "a diagram without an entry mode"
    MASKED_TRANSITION "LM0402" "masked-transition" Warning "a transition that higher ones always keep from being taken"
    DUPLICATE_PRIORITY "LM0403" "duplicate-priority" Error "two transitions of one mode with one priority"
    UNREACHABLE_MODE "LM0404" "unreachable-mode" Warning "a mode no path of transitions leads to"
    ENTRY_REQUIRES "LM0405" "entry-requires-optional" Error "an entry mode that requires an optional sensor"
    DEAD_END "LM0406" "dead-end" Warning "a mode without a way out that is not marked `final`"
    FINAL_WITH_EXIT "LM0407" "final-with-exit" Error "a `final` mode with a transition"
    REQUIRES_WITHOUT_ELSE "LM0408" "requires-without-else" Warning "a required sensor with nowhere to go when it fails"
    CONDITION_NEVER_TRUE "LM0409" "condition-never-true" Warning "a condition that no readings make true"
    CONDITION_ALWAYS_TRUE "LM0410" "condition-always-true" Warning "a condition that always holds, above other transitions"
    LEFT_AT_ONCE "LM0411" "mode-left-at-once" Warning "a mode that is always left on its first tick"
    SAME_CONDITION_TWICE "LM0412" "same-condition-twice" Warning "two transitions of one mode with one condition"
    TIMER_NEVER_REACHED "LM0413" "timer-never-reached" Warning "a time that the mode never lasts"
    UNREACHABLE_BY_GUARDS "LM0414" "unreachable-by-guards" Warning "a mode to which no transition is ever taken"
    TRAP "LM0415" "trap" Warning "modes that can never be left and are not final"
    ONE_TICK_CYCLE "LM0416" "one-tick-cycle" Warning "modes that follow each other on every tick"
    ISLAND_OF_MODES "LM0417" "island-of-modes" Warning "modes that lead only to each other"
    ALWAYS_INHIBITED "LM0418" "always-inhibited" Warning "a transition that holds only while its target is inhibited"
    SWAPPING_MODES "LM0419" "swapping-modes" Warning "two modes that noise alone drives to and fro"
    TIMER_RESTARTED "LM0420" "timer-restarted" Warning "a time that `again` always restarts before it ends"
    OSCILLATION "LM0421" "oscillation" Info "modes that the same readings drive round and round"
    COMMAND_OVERRIDDEN "LM0422" "command-overridden" Warning "a command that another overrides on the same tick"
    DECISION_INCOMPLETE "LM0423" "decision-incomplete" Error "a decision table without a row for some case"
    DECISION_OVERLAP "LM0424" "decision-overlap" Error "a decision table with two rows for one case"
    ROW_NEVER_CHOSEN "LM0425" "row-never-chosen" Warning "a row of a decision table that no reading fits"
    LAYER_INVERTED "LM0426" "layer-inverted" Error "a mode that runs a diagram of its own layer or an outer one"
    PREEMPTED "LM0427" "pre-empted-transition" Warning "a transition that an outer layer always forestalls"
    SILENT_LAYER "LM0428" "silent-layer" Warning "a mode that runs a diagram without any command"

    BREAKPOINTS_OUT_OF_ORDER "LM0501" "breakpoints-out-of-order" Error "corners of a membership function that do not ascend"
    TERM_OUTSIDE_RANGE "LM0502" "term-outside-range" Warning "a term that is zero over the whole range of its variable"
    RANGE_NOT_COVERED "LM0503" "range-not-covered" Warning "readings that belong to no term of their variable"
    ROW_LENGTH "LM0504" "row-length" Error "a row whose cells do not match the inputs"
    NO_CONTRIBUTOR "LM0505" "no-contributor" Error "an event that no rule can set"
    EVENT_NEVER_SET "LM0506" "event-never-set" Error "an event that no readings set"
    EVENT_ALWAYS_SET "LM0507" "event-always-set" Warning "an event that all readings set"
    TIE "LM0508" "tie" Warning "both sides of an event equally strong, above 0.5, around some readings"
    DEAD_ZONE "LM0509" "dead-zone" Info "readings around which no rule of an event fires"
    RULE_ON_BOTH_SIDES "LM0510" "rule-on-both-sides" Error "a rule that speaks for an event and against it"
    DUPLICATE_RULE "LM0511" "duplicate-rule" Warning "a rule that stands twice on one side of an event"
    RULE_NEVER_FIRES "LM0512" "rule-never-fires" Warning "a rule whose terms never hold together"
    SUBSUMED_RULE "LM0513" "subsumed-rule" Warning "a rule that a wider one says already"
    RULE_NEVER_DECISIVE "LM0514" "rule-never-decisive" Warning "a rule without which an event would be the same"
    IDLE_DETRACTOR "LM0515" "idle-detractor" Info "a detractor rule that keeps no flag clear"
    DUPLICATE_TERM "LM0516" "duplicate-term" Warning "two terms of a variable that are the same set"
    TERM_VANISHES_AT_END "LM0517" "term-vanishes-at-end" Warning "an outermost term that is 0 at the end of the range"
    NO_DETRACTOR "LM0518" "no-detractor" Info "an event that no rule speaks against"
    RELATED_EVENTS "LM0519" "related-events" Info "events that imply, equal or exclude each other"
    NEEDLESS_INPUT "LM0520" "needless-input" Info "an input that an event names and does not depend on"
    COMPARISON "LM0521" "single-comparison" Info "an event that is a comparison of one input with one number"
    WEAK_ANY "LM0522" "weak-any" Info "`_` where it is not the same as leaving the input out"
    UNUSED_INPUT "LM0523" "unused-input" Info "an input of a network that no rule names"
    UNSTEADY_AT_REST "LM0524" "unsteady-at-rest" Info "a flag that the least noise changes while the robot is at rest"
    NOISE_ABOVE_MARGIN "LM0525" "noise-above-margin" Warning "a flag that sensor noise changes while the robot is at rest"
    WEAK_TIE "LM0526" "weak-tie" Info "both sides of an event equally strong, not above 0.5, around some readings"
    OUTPUT_GAP "LM0527" "output-gap" Error "an output without `default` that no rule sets at some readings"
    SET_WITHOUT_AREA "LM0528" "set-without-area" Error "a set of an output that its defuzzifier cannot see"
    NOT_EXACT "LM0529" "not-exact" Error "sets of an output that cannot be defuzzified exactly, as is asked"

    FAIL_READING_OUTSIDE_RANGE "LM0601" "fail-reading-outside-range" Error "a fail reading outside the sensor's range"
    SINGLE_POINT_OF_FAILURE "LM0602" "single-point-of-failure" Warning "an event of several sensors that one failure keeps from being set"
    EVENT_STUCK_SET "LM0603" "event-stuck-set" Warning "an event of several sensors that one failure keeps set"
    TRAPPED_BY_FAILURE "LM0604" "trapped-by-failure" Warning "modes that can never be left while a sensor has failed"
    NO_SAFE_MODE "LM0605" "no-safe-mode" Warning "modes from which a failure closes the ways to every safe one"
    SENSOR_WITHOUT_FAILS "LM0606" "sensor-without-fails" Warning "a sensor in use that does not say how it fails"
    MODE_MISSED "LM0607" "mode-missed" Info "a mode that is never reached by a machine that starts with a failed sensor"
    INTERMITTENT_FAILURE "LM0608" "intermittent-failure" Info "two modes between which a failure that comes and goes drives to and fro"

    REACTS_TOO_LATE "LM0701" "reacts-too-late" Warning "a robot that can be at an obstacle before it stands"

    BAD_PLACEMENT "LM0801" "bad-placement" Error "a scenario whose bodies overlap at the start"
    NO_SCENARIO "LM0802" "no-scenario" Error "a file without a scenario to run"
    RUN_TOO_LONG "LM0803" "run-too-long" Error "a scenario with more ticks than can be recorded"
    PROPERTY_REFUTED "LM0804" "property-refuted" Error "a property that some run of the behavior breaks"
    PROPERTY_UNDECIDED "LM0805" "property-undecided" Info "a property that is neither proved nor refuted"
    NEVER_FAILS "LM0806" "expectation-never-fails" Warning "an expectation that no run can miss"
    WINDOW_OUTSIDE_RUN "LM0807" "window-outside-run" Warning "a fault or an expectation in a time that no tick lies in"
    DOOR_OFF_WALL "LM0808" "door-off-wall" Error "a door that does not lie on a wall"

    TIE_WITHOUT_ORDER "LM0901" "tie-without-order" Warning "clients of one priority, and nothing that says who wins"
    CLIENT_NEVER_WINS "LM0902" "client-never-wins" Warning "a client that another one always keeps from winning"
    EMERGENCY_SHARES_PATH "LM0903" "emergency-shares-path" Error "an emergency whose command does not bypass the others"

    INTERNAL "LM9901" "internal-error" Error "a fault of the compiler itself"
}
