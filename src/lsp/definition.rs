//! Where what a name means is declared, and where else it is named.

use lsp_types::Location;

use super::folder::Folder;
use super::known::Known;
use crate::base::Span;

/// The declarations of what a name means; of one that is declared here, those it stands in the place of, or else itself.
pub(super) fn definition(known: &Known, name: Span, folder: &Folder) -> Vec<Location> {
    let mut places: Vec<_> = known.meanings(name).collect();
    if places.is_empty() {
        places.push(name);
    }
    places.into_iter().filter_map(|place| known.location(place, folder)).collect()
}

/// Every place that names the same, with the declarations or without.
pub(super) fn references(known: &Known, name: Span, declarations: bool, folder: &Folder) -> Vec<Location> {
    let kin = known.kin(name).into_iter();
    let wanted = kin.filter(|place| declarations || !known.declared().contains_key(place));
    wanted.filter_map(|place| known.location(place, folder)).collect()
}
