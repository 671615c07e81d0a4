//! A run from deck to files: reads the deck, steps through its `$YDOIT`
//! stages, and gives every output writer what it asks for.

mod load;
mod observer;
mod restage;
mod run;
mod summary;

pub use load::{DeckFault, LoadedDeck, load};
pub use observer::{Observer, Progress, Silent};
pub use run::{RunError, RunOptions, run};
pub use summary::{RunSummary, StopReason};

use serde::{Deserialize, Serialize};

/// A kind of result files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// d3plot family for LS-PrePost.
    D3plot,
    /// Histories, `DECK` + `h0`, `h1`, ...
    Yh,
    /// VTU files and a PVD collection for ParaView.
    Vtu,
    /// Machine-readable summary of the run.
    Json,
}
