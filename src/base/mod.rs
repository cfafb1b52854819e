//! What every room needs: places in text, the texts themselves, typed ids, exact quantities.
//!
//! Imports: –
//! Crates: num-bigint, num-rational, num-traits

mod arena;
mod fraction;
mod quantity;
mod read;
mod source;
mod span;
mod unit;

pub use arena::{Arena, Id};
pub use fraction::Fraction;
pub use quantity::{Dimension, Exact, Quantity};
pub use read::read_quantity;
pub use source::{Source, Sources};
pub use span::{FileId, Span};
pub use unit::{UNITS, Unit, UnitName, find_unit, show_time};
