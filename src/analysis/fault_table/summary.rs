//! What a fault table says, in sentences.

use super::event_words::Subject;
use super::{Group, Sensed, mode_words};
use crate::analysis::failures::{Failed, failed};
use crate::ir::Program;

/// Sentences about what always holds, and then about what failures do, few failed sensors first.
pub(super) fn summary(program: &Program, group: &Group, models: &[Sensed<'_>], up_to: usize) -> Vec<String> {
    let (mut always, mut told) = (Vec::new(), Told::default());
    for sensed in models {
        let relations = sensed.facts.first().map(|facts| sensed.model.relations(facts)).unwrap_or_default();
        for index in 0..sensed.network.events.len() {
            let Some(event) = Subject::new(group, sensed, index, models.len() > 1) else { continue };
            always.extend(event.always(&relations));
            event.under_failures(&mut told);
        }
    }
    for &diagram in &group.diagrams {
        mode_words::under_failures(program, &program.diagrams[diagram], up_to, &mut told);
    }
    always.into_iter().chain(told.sentences()).collect()
}

/// What is true under some sets of failed sensors; what is true under the same ones is told together.
#[derive(Default)]
pub(super) struct Told<'a>(Vec<(Vec<Vec<Failed<'a>>>, Vec<String>)>);

impl<'a> Told<'a> {
    pub(super) fn tell(&mut self, sets: Vec<Vec<Failed<'a>>>, what: String) {
        let is_among = |set: &Vec<_>, sets: &[Vec<_>]| {
            sets.iter().any(|other| other.len() == set.len() && set.iter().all(|failed| other.contains(failed)))
        };
        let is_same = |known: &[Vec<_>]| known.len() == sets.len() && known.iter().all(|set| is_among(set, &sets));
        match self.0.iter_mut().find(|(known, _)| is_same(known)) {
            Some((_, clauses)) => clauses.push(what),
            None => self.0.push((sets, vec![what])),
        }
    }

    /// The sets, each with what is true under them.
    pub(super) fn groups(self) -> impl Iterator<Item = (Vec<Vec<Failed<'a>>>, Vec<String>)> {
        self.0.into_iter()
    }

    fn sentences(mut self) -> impl Iterator<Item = String> {
        self.0.sort_by_key(|(sets, _)| sets.first().map_or(0, Vec::len));
        self.groups().map(|(sets, clauses)| format!("With {}, {}.", failed(&sets), clauses.join("; ")))
    }
}

/// Sets that hold none of those that are known, each with what is known of it: a larger set adds nothing to it.
pub(super) fn add_smallest<'s, What: PartialEq, Fault: PartialEq>(
    known: &mut Vec<(What, Vec<&'s Vec<Fault>>)>,
    what: What,
    set: &'s Vec<Fault>,
) {
    match known.iter_mut().find(|(known, _)| *known == what) {
        Some((_, sets)) if sets.iter().any(|smaller| smaller.iter().all(|fault| set.contains(fault))) => {}
        Some((_, sets)) => sets.push(set),
        None => known.push((what, vec![set])),
    }
}
