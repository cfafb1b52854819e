//! The standard library, embedded in the binary.

use crate::base::{FileId, Sources};
use crate::diag::{Diagnostic, rules};

/// Every file of the standard library: its path, and its text. `std/robots/j5.msd` is imported as `std.robots.j5`.
pub const LIBRARY: &[(&str, &str)] = &[
    ("std/activities/clear_area.msd", include_str!("../../stdlib/activities/clear_area.msd")),
    ("std/activities/hybrid_navigation.msd", include_str!("../../stdlib/activities/hybrid_navigation.msd")),
    ("std/activities/patrol_area.msd", include_str!("../../stdlib/activities/patrol_area.msd")),
    ("std/activities/return_home.msd", include_str!("../../stdlib/activities/return_home.msd")),
    ("std/activities/search.msd", include_str!("../../stdlib/activities/search.msd")),
    ("std/behaviors/arc.msd", include_str!("../../stdlib/behaviors/arc.msd")),
    ("std/behaviors/back_and_forth.msd", include_str!("../../stdlib/behaviors/back_and_forth.msd")),
    ("std/behaviors/collision_avoidance.msd", include_str!("../../stdlib/behaviors/collision_avoidance.msd")),
    (
        "std/behaviors/collision_avoidance_as_printed.msd",
        include_str!("../../stdlib/behaviors/collision_avoidance_as_printed.msd"),
    ),
    ("std/behaviors/dock.msd", include_str!("../../stdlib/behaviors/dock.msd")),
    ("std/behaviors/drive.msd", include_str!("../../stdlib/behaviors/drive.msd")),
    ("std/behaviors/explore.msd", include_str!("../../stdlib/behaviors/explore.msd")),
    ("std/behaviors/follow_corridor.msd", include_str!("../../stdlib/behaviors/follow_corridor.msd")),
    ("std/behaviors/follow_wall.msd", include_str!("../../stdlib/behaviors/follow_wall.msd")),
    ("std/behaviors/fuzzy_navigation.msd", include_str!("../../stdlib/behaviors/fuzzy_navigation.msd")),
    (
        "std/behaviors/fuzzy_navigation_as_printed.msd",
        include_str!("../../stdlib/behaviors/fuzzy_navigation_as_printed.msd"),
    ),
    ("std/behaviors/goal_seeking.msd", include_str!("../../stdlib/behaviors/goal_seeking.msd")),
    ("std/behaviors/halt.msd", include_str!("../../stdlib/behaviors/halt.msd")),
    ("std/behaviors/obstacle_avoidance.msd", include_str!("../../stdlib/behaviors/obstacle_avoidance.msd")),
    ("std/behaviors/obstacle_manipulation.msd", include_str!("../../stdlib/behaviors/obstacle_manipulation.msd")),
    ("std/behaviors/open_area_seeking.msd", include_str!("../../stdlib/behaviors/open_area_seeking.msd")),
    ("std/behaviors/push.msd", include_str!("../../stdlib/behaviors/push.msd")),
    ("std/behaviors/seek_goal.msd", include_str!("../../stdlib/behaviors/seek_goal.msd")),
    ("std/behaviors/seek_open_area.msd", include_str!("../../stdlib/behaviors/seek_open_area.msd")),
    ("std/behaviors/simple_navigation.msd", include_str!("../../stdlib/behaviors/simple_navigation.msd")),
    ("std/behaviors/turn.msd", include_str!("../../stdlib/behaviors/turn.msd")),
    ("std/interfaces/alert_base.msd", include_str!("../../stdlib/interfaces/alert_base.msd")),
    ("std/interfaces/located_base.msd", include_str!("../../stdlib/interfaces/located_base.msd")),
    ("std/interfaces/mobile_base.msd", include_str!("../../stdlib/interfaces/mobile_base.msd")),
    ("std/interfaces/pushing_base.msd", include_str!("../../stdlib/interfaces/pushing_base.msd")),
    ("std/interfaces/ranging_base.msd", include_str!("../../stdlib/interfaces/ranging_base.msd")),
    ("std/networks/clearances.fsfn", include_str!("../../stdlib/networks/clearances.fsfn")),
    ("std/networks/navigator.fsfn", include_str!("../../stdlib/networks/navigator.fsfn")),
    ("std/networks/navigator_as_printed.fsfn", include_str!("../../stdlib/networks/navigator_as_printed.fsfn")),
    ("std/networks/obstacle_id.fsfn", include_str!("../../stdlib/networks/obstacle_id.fsfn")),
    ("std/networks/open_area.fsfn", include_str!("../../stdlib/networks/open_area.fsfn")),
    ("std/networks/preliminary_obstacle_id.fsfn", include_str!("../../stdlib/networks/preliminary_obstacle_id.fsfn")),
    ("std/robots/car.msd", include_str!("../../stdlib/robots/car.msd")),
    ("std/robots/j5.msd", include_str!("../../stdlib/robots/j5.msd")),
    ("std/robots/labmate.msd", include_str!("../../stdlib/robots/labmate.msd")),
    ("std/robots/scout.msd", include_str!("../../stdlib/robots/scout.msd")),
    ("std/variables/j5.fsfn", include_str!("../../stdlib/variables/j5.fsfn")),
    ("std/variables/labmate.fsfn", include_str!("../../stdlib/variables/labmate.fsfn")),
    ("std/variables/navigation.fsfn", include_str!("../../stdlib/variables/navigation.fsfn")),
];

/// The text of a file of the library.
pub(super) fn find(path: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(known, _)| *known == path).map(|(_, text)| *text)
}

/// Whether a file is one of the library, and not one of the user's.
pub(super) fn holds(sources: &Sources, file: FileId) -> bool {
    find(sources.path(file)).is_some()
}

/// Names the import to write, where a name is declared nowhere but a file of the library is called so.
pub(super) fn suggest(findings: &mut [Diagnostic], sources: &Sources) {
    for finding in
        findings.iter_mut().filter(|finding| finding.rule == &rules::UNKNOWN_NAME && finding.labels.len() == 1)
    {
        let name = sources.slice(finding.span());
        let fits = |known: &String| known.rsplit('.').next() == Some(name);
        if let Some(known) = names().find(|known| !known.contains(".variables.") && fits(known)) {
            finding.help = Some(format!("write `import {known}`"));
        }
    }
}

/// The names under which the library's files are imported.
pub(super) fn names() -> impl Iterator<Item = String> {
    LIBRARY.iter().filter_map(|(path, _)| Some(path.rsplit_once('.')?.0.replace('/', ".")))
}
