//! What files declare, as an outline and as a list to search.

use lsp_types::{DocumentSymbol, SymbolInformation, SymbolKind};

use super::folder::{Folder, LIBRARY};
use super::known::Known;
use super::names::Entity;
use crate::base::{FileId, Span};
use crate::syntax::ast::{self, DiagramItem, Item, NetworkItem, OutputBody, RobotItem};

/// The outline of a file, from its text alone: also of what has no meaning.
pub(super) fn outline(known: &Known, file: FileId) -> Vec<DocumentSymbol> {
    let units = known.analysis.units.iter().filter(|unit| unit.file == file);
    units.flat_map(|unit| &unit.tree.items).filter_map(|item| Outline { known }.item(item)).collect()
}

struct Outline<'a> {
    known: &'a Known,
}

impl Outline<'_> {
    fn item(&self, item: &Item) -> Option<DocumentSymbol> {
        let (name, kind, parts) = match item {
            Item::Variable(variable) => (&variable.name, SymbolKind::ENUM, self.terms(&variable.terms)),
            Item::Network(network) => (&network.name, SymbolKind::MODULE, self.network(network)),
            Item::Interface(interface) => (&interface.name, SymbolKind::INTERFACE, self.members(&interface.items)),
            Item::Robot(robot) => (&robot.name, SymbolKind::CLASS, self.members(&robot.items)),
            Item::Diagram(diagram) => (&diagram.name, SymbolKind::CLASS, self.diagram(diagram)),
            Item::World(world) => (&world.name, SymbolKind::OBJECT, Vec::new()),
            Item::Scenario(scenario) => (&scenario.name, SymbolKind::FUNCTION, Vec::new()),
            Item::Property(property) => (&property.name, SymbolKind::BOOLEAN, Vec::new()),
            Item::Arbiter(arbiter) => (&arbiter.name, SymbolKind::CLASS, Vec::new()),
            Item::Team(team) => (&team.name, SymbolKind::CLASS, Vec::new()),
            Item::Import(_) | Item::Error(_) => return None,
        };
        Some(self.symbol(name, kind, item.span(), parts))
    }

    #[expect(deprecated, reason = "the field must be given")]
    fn symbol(&self, name: &ast::Name, kind: SymbolKind, whole: Span, parts: Vec<DocumentSymbol>) -> DocumentSymbol {
        DocumentSymbol {
            name: name.text.clone(),
            detail: None,
            kind,
            tags: None,
            deprecated: None,
            range: self.known.range(whole.to(name.span)),
            selection_range: self.known.range(name.span),
            children: (!parts.is_empty()).then_some(parts),
        }
    }

    fn part(&self, name: &ast::Name, kind: SymbolKind, whole: Span) -> DocumentSymbol {
        self.symbol(name, kind, whole, Vec::new())
    }

    fn terms(&self, terms: &[ast::Term]) -> Vec<DocumentSymbol> {
        terms.iter().map(|term| self.part(&term.name, SymbolKind::ENUM_MEMBER, term.span)).collect()
    }

    fn network(&self, network: &ast::Network) -> Vec<DocumentSymbol> {
        let part = |item: &NetworkItem| match item {
            NetworkItem::Event(event) => Some(self.part(&event.name, SymbolKind::EVENT, event.span)),
            NetworkItem::Output(output) => {
                let terms = match &output.body {
                    OutputBody::Terms(terms) => self.terms(terms),
                    OutputBody::TakagiSugeno(_) => Vec::new(),
                };
                Some(self.symbol(&output.name, SymbolKind::FIELD, output.span, terms))
            }
            NetworkItem::Rule(_) | NetworkItem::Error(_) => None,
        };
        network.items.iter().filter_map(part).collect()
    }

    fn members(&self, items: &[RobotItem]) -> Vec<DocumentSymbol> {
        let part = |item: &RobotItem| match item {
            RobotItem::Sensor(sensor) => Some(self.part(&sensor.name, SymbolKind::FIELD, sensor.span)),
            RobotItem::Logical(logical) => Some(self.part(&logical.name, SymbolKind::FIELD, logical.span)),
            RobotItem::Action(action) => Some(self.part(&action.name, SymbolKind::METHOD, action.span)),
            RobotItem::Body(_) | RobotItem::Sense(_) | RobotItem::Error(_) => None,
        };
        items.iter().filter_map(part).collect()
    }

    fn diagram(&self, diagram: &ast::Diagram) -> Vec<DocumentSymbol> {
        let part = |item: &DiagramItem| match item {
            DiagramItem::Flag(flag) => Some(self.part(&flag.name, SymbolKind::BOOLEAN, flag.span)),
            DiagramItem::Mode(mode) => Some(self.part(&mode.name, SymbolKind::ENUM_MEMBER, mode.span)),
            DiagramItem::Sense(_) | DiagramItem::Entry { .. } | DiagramItem::Error(_) => None,
        };
        diagram.items.iter().filter_map(part).collect()
    }
}

/// What is declared in the user's files under a name that has the letters of a query in their order.
#[expect(deprecated, reason = "a field must be given")]
pub(super) fn search(known: &Known, query: &str, folder: &Folder) -> Vec<SymbolInformation> {
    let query = query.to_lowercase();
    let sources = &known.analysis.sources;
    let own = known.declared().iter().filter(|(place, _)| !sources.path(place.file).starts_with(LIBRARY));
    let found = own.filter_map(|(&place, &entity)| {
        let name = sources.slice(place);
        let letters = name.to_lowercase();
        let mut rest = letters.chars();
        let fits = query.chars().all(|wanted| rest.any(|letter| letter == wanted));
        let location = known.location(place, folder).filter(|_| fits)?;
        let (name, kind) = (name.to_owned(), kind(entity)?);
        Some(SymbolInformation { name, kind, tags: None, deprecated: None, location, container_name: None })
    });
    found.collect()
}

/// How an editor marks what is declared; nothing for what is a part of a line.
fn kind(entity: Entity) -> Option<SymbolKind> {
    Some(match entity {
        Entity::Variable(_) => SymbolKind::ENUM,
        Entity::Term(..) | Entity::OutputTerm(..) | Entity::Mode(..) => SymbolKind::ENUM_MEMBER,
        Entity::Network(_) => SymbolKind::MODULE,
        Entity::Event(..) => SymbolKind::EVENT,
        Entity::Output(..) | Entity::Sensor(_) => SymbolKind::FIELD,
        Entity::Interface(_) => SymbolKind::INTERFACE,
        Entity::Robot(_) | Entity::Diagram(_) => SymbolKind::CLASS,
        Entity::Action(_) => SymbolKind::METHOD,
        Entity::Flag(..) | Entity::Property(_) => SymbolKind::BOOLEAN,
        Entity::World(_) => SymbolKind::OBJECT,
        Entity::Scenario(_) => SymbolKind::FUNCTION,
        Entity::Input(..) | Entity::Parameter(..) | Entity::Sense(..) => return None,
    })
}
