//! The standard library, embedded in the binary.

/// Every file of the standard library: its path, and its text. `std/robots/j5.msd` is imported as `std.robots.j5`.
pub const LIBRARY: &[(&str, &str)] = &[
    ("std/behaviors/obstacle_avoidance.msd", include_str!("../../stdlib/behaviors/obstacle_avoidance.msd")),
    ("std/behaviors/obstacle_manipulation.msd", include_str!("../../stdlib/behaviors/obstacle_manipulation.msd")),
    ("std/interfaces/mobile_base.msd", include_str!("../../stdlib/interfaces/mobile_base.msd")),
    ("std/networks/obstacle_id.fsfn", include_str!("../../stdlib/networks/obstacle_id.fsfn")),
    ("std/networks/preliminary_obstacle_id.fsfn", include_str!("../../stdlib/networks/preliminary_obstacle_id.fsfn")),
    ("std/robots/j5.msd", include_str!("../../stdlib/robots/j5.msd")),
    ("std/variables/j5.fsfn", include_str!("../../stdlib/variables/j5.fsfn")),
];

/// The text of a file of the library.
pub(super) fn find(path: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(known, _)| *known == path).map(|(_, text)| *text)
}

/// The names under which the library's files are imported.
pub(super) fn names() -> impl Iterator<Item = String> {
    LIBRARY.iter().filter_map(|(path, _)| Some(path.rsplit_once('.')?.0.replace('/', ".")))
}
