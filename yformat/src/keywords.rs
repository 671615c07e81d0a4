//! The keywords of every dialect as data.
//!
//! One [`Keyword`] holds all that is known about a name: how it is matched, what it holds, its
//! defaults, its unit and its meaning. Parser, writer, [`Database`](crate::database::Database) and
//! the keyword reference read the same tables.
//!
//! ```
//! use yformat::dialect::Dialect;
//! use yformat::keywords;
//!
//! let keyword = keywords::find(Dialect::Split, "YDPE/D1PERO").unwrap();
//! assert_eq!(keyword.unit, "kg/m³");
//! assert_eq!(keyword.rank(), 1);
//! ```

mod classic;
mod keyword;
mod loads;
mod output;
mod reference;
mod split;
mod suggest;
mod table;
mod y3d;
mod ygeo;

pub use keyword::{Adjustment, Created, Extent, Keyword, NumberKind, Role};
pub use reference::reference;
pub use suggest::{dialects_knowing, similar};
pub use table::{Table, find, match_word, table, tables};
