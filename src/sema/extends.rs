//! Declarations that take over others.

use super::Lower;
use crate::base::Span;
use crate::diag::{self, Diagnostic};
use crate::syntax::ast;

/// A declaration that may extend another of its kind.
pub(super) trait Extends {
    fn name(&self) -> &ast::Name;
    fn extends(&self) -> Option<&ast::Name>;
}

impl Extends for ast::Diagram {
    fn name(&self) -> &ast::Name {
        &self.name
    }

    fn extends(&self) -> Option<&ast::Name> {
        self.extends.as_ref()
    }
}

impl Extends for ast::Interface {
    fn name(&self) -> &ast::Name {
        &self.name
    }

    fn extends(&self) -> Option<&ast::Name> {
        self.extends.as_ref()
    }
}

impl Extends for ast::Scenario {
    fn name(&self) -> &ast::Name {
        &self.name
    }

    fn extends(&self) -> Option<&ast::Name> {
        self.extends.as_ref()
    }
}

impl<'a> Lower<'a> {
    /// What `tree` takes over and itself, the oldest first; `None` where declarations extend each other in a circle, or
    /// one is missing.
    pub(super) fn chain<T: Extends>(
        &mut self,
        tree: &'a T,
        find: impl Fn(&mut Self, &ast::Name) -> Option<&'a T>,
    ) -> Option<Vec<&'a T>> {
        let mut chain = vec![tree];
        while let Some(name) = chain.last()?.extends() {
            let base = find(self, name)?;
            if let Some(first) = chain.iter().position(|known| known.name().span == base.name().span) {
                let names: Vec<_> = chain[first..].iter().map(|tree| tree.name()).collect();
                self.circle(tree.name(), &names, name.span);
                return None;
            }
            chain.push(base);
        }
        chain.reverse();
        Some(chain)
    }

    /// Reports a circle of declarations that extend each other, once: where the first of them in the text is looked
    /// at. `names` are the circle's in the order in which they extend each other, and `span` is where the last of them
    /// names the first.
    fn circle(&mut self, looked_at: &ast::Name, names: &[&ast::Name], span: Span) {
        let Some(first) = names.iter().map(|name| name.span).min() else { return };
        if looked_at.span != first {
            return;
        }
        let list: Vec<_> = names.iter().chain(names.first()).map(|name| format!("`{}`", name.text)).collect();
        let diagnostic = match names {
            [one] => Diagnostic::new(&diag::rules::CIRCULAR, span, format!("`{}` extends itself", one.text)),
            _ => {
                let message = format!("`{}` extends itself through others", looked_at.text);
                Diagnostic::new(&diag::rules::CIRCULAR, first, message)
                    .note(format!("the circle: {}", list.join(" extends ")))
            }
        };
        self.report(diagnostic.help("one of them must stand on its own"));
    }
}
