//! Histories: the `.yh` text files that follow one quantity through time.
//!
//! Each line holds a time and a value. The classic dialect puts a second line below each, a
//! blank in front, with the sums of the contact forces in x and y.
//!
//! ```
//! use yformat::history::{History, HistoryWriter, LineStyle};
//!
//! let mut writer = HistoryWriter::new(Vec::new(), LineStyle::Unix);
//! writer.write(5.0e-4, 11.76879)?;
//! let text = writer.into_inner();
//! assert_eq!(text, b"+5.0000000000e-04 +1.1768790000e+01\n");
//!
//! let history = History::parse(&text)?;
//! assert_eq!(history.points[0].value, 11.76879);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod number;
mod reader;
mod writer;

pub use reader::{History, HistoryError, HistoryPoint};
pub use writer::{HistoryWriter, LineStyle};
