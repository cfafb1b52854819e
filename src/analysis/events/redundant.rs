//! Rules that an event can do without, all of them together: one finding for each, the one that says most.

use super::{HEALTHY, Question, Subject};
use super::{duplicate_rule, idle_detractor, never_decisive, never_fires, subsumed};
use crate::base::Span;
use crate::diag::Diagnostic;

/// What one written rule stands for: a rule in words may stand for several.
pub(super) struct Written {
    pub(super) span: Span,
    /// By their numbers, contributors first.
    pub(super) rules: Vec<usize>,
}

/// The rules that are reported.
pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> Vec<usize> {
    let written = written(subject);
    let wider = subject.model.wider_rules(subject.index);
    let fires = |rule: usize| subject.rule_facts(rule).fires.is_possible();
    let mut left_out: Vec<usize> = Vec::new();
    let mut by_form = Vec::new();
    let mut others = Vec::new();
    // The later of two equal rules is the one too many.
    for group in written.iter().rev() {
        let stands = |other: &usize| !group.rules.contains(other) && !left_out.contains(other);
        if group.rules.iter().all(|&rule| !fires(rule) || wider[rule].iter().any(stands)) {
            left_out.extend(&group.rules);
            by_form.push(group);
        } else {
            others.push(group);
        }
    }
    for group in by_form {
        let standing = |rule: usize| wider[rule].iter().copied().find(|other| !left_out.contains(other));
        match group.rules.iter().copied().find(|&rule| fires(rule)) {
            None => never_fires::found(subject, group, findings),
            Some(rule) => {
                let Some(other) = standing(rule) else { continue };
                if wider[other].contains(&rule) {
                    findings.push(duplicate_rule::duplicate(subject, group, other));
                } else {
                    findings.push(subsumed::subsumed(subject, group, other));
                }
            }
        }
    }
    if !subject.is_large() {
        by_effect(subject, &others, &mut left_out, findings);
    }
    left_out
}

/// Rules of which only their effect shows that they are not needed.
fn by_effect(subject: &Subject<'_>, written: &[&Written], left_out: &mut Vec<usize>, findings: &mut Vec<Diagnostic>) {
    let decisive: fn(usize) -> Question = Question::Decisive;
    let strongest: fn(usize) -> Question = Question::Strongest;
    // With hysteresis it matters by how much a side is larger.
    let contributors = if subject.has_hysteresis() { strongest } else { decisive };
    let mut idle = Vec::new();
    for (question, of_contributors) in [(contributors, true), (strongest, false)] {
        let of_side = written.iter().filter(|group| subject.contributes(group.rules[0]) == of_contributors);
        let candidates: Vec<_> =
            of_side.filter(|group| group.rules.iter().all(|&rule| subject.is_never(question(rule)))).collect();
        let groups: Vec<_> = candidates.iter().map(|group| group.rules.clone()).collect();
        for found in subject.model.needless_rules(subject.index, &HEALTHY, question, left_out, &groups) {
            idle.push((candidates[found], question));
        }
        left_out.extend(idle.iter().flat_map(|(group, _)| &group.rules));
    }
    for (group, question) in &idle {
        let reasons = subject.reasons(group, *question, left_out);
        findings.push(never_decisive::never_decisive(subject, group, &reasons));
    }
    if subject.has_hysteresis() {
        return;
    }
    let is_left = |group: &&&Written| {
        group
            .rules
            .iter()
            .all(|&rule| !left_out.contains(&rule) && !subject.contributes(rule) && subject.is_never(decisive(rule)))
    };
    let candidates: Vec<_> = written.iter().filter(is_left).collect();
    let groups: Vec<_> = candidates.iter().map(|group| group.rules.clone()).collect();
    for found in subject.model.needless_rules(subject.index, &HEALTHY, decisive, left_out, &groups) {
        findings.push(idle_detractor::idle(subject, candidates[found]));
    }
}

/// The written rules of both sides, in order.
fn written(subject: &Subject<'_>) -> Vec<Written> {
    let mut written: Vec<Written> = Vec::new();
    let rules = subject.event.contributor.iter().chain(&subject.event.detractor).map(|rule| rule.span);
    for (rule, span) in rules.enumerate() {
        match written.last_mut() {
            Some(last) if last.span == span && rule != subject.event.contributor.len() => last.rules.push(rule),
            _ => written.push(Written { span, rules: vec![rule] }),
        }
    }
    written
}

impl Subject<'_> {
    fn is_never(&self, question: Question) -> bool {
        let verdict = match question {
            Question::Decisive(rule) => &self.rule_facts(rule).decisive,
            Question::Strongest(rule) => &self.rule_facts(rule).strongest,
            Question::Fires(rule) => &self.rule_facts(rule).fires,
            Question::Set => &self.facts.set,
            Question::Clear => &self.facts.clear,
            Question::Tie => &self.facts.tie,
            Question::Dead => &self.facts.dead,
        };
        !verdict.is_possible()
    }

    /// Other rules that make a written rule needless once all needless ones but it are left out.
    fn reasons(&self, group: &Written, question: fn(usize) -> Question, left_out: &[usize]) -> Vec<usize> {
        let of_rule = |&rule: &usize| {
            let others: Vec<_> = left_out.iter().copied().filter(|&other| other != rule).collect();
            self.model.reasons(self.index, &HEALTHY, question, rule, &others)
        };
        let mut reasons: Vec<_> = group.rules.iter().flat_map(of_rule).collect();
        reasons.sort_unstable();
        reasons.dedup();
        reasons
    }
}
