//! A run from deck to files: reads the deck, steps through its `$YDOIT`
//! stages, and gives every output writer what it asks for.

mod checkpoint;
mod guard;
mod load;
mod model;
mod observer;
mod restage;
mod resume;
mod run;
mod scenario;
mod settle;
mod summary;
mod writers;

pub use checkpoint::{Checkpoint, CheckpointError, Checkpoints, RunSettings};
pub use guard::OnInstability;
pub use load::{DeckFault, LoadedDeck, load, prepare};
pub use model::SceneSize;
pub use observer::{Observer, Progress, Silent};
pub use run::{RunError, RunOptions, Watch, run, run_with};
pub use scenario::{
    ScenarioDeck, ScenarioError, deck_of_scenario, monitors, write as write_generated,
};
pub use settle::SettlingSummary;
pub use summary::{RunSummary, StopReason};

use serde::{Deserialize, Serialize};
use yformat::dialect::Dialect;

/// A kind of result files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// What the deck's original program writes: d3plot and yh (split), ym, yh and
    /// restart (classic), vtp and yh (Y-Geo).
    Native,
    /// d3plot family for LS-PrePost.
    D3plot,
    /// Histories, `DECK` + `h0`, `h1`, ...
    Yh,
    /// `.ym` snapshots and `contactforce.txt` (classic).
    Ym,
    /// Restart decks and their `.msh` meshes at the deck's intervals (classic).
    Restart,
    /// Families of `.vtp` and `.vtu` files as Y-Geo writes them.
    Vtp,
    /// VTU files and a PVD collection for ParaView.
    Vtu,
    /// Machine-readable summary of the run.
    Json,
}

impl Format {
    /// The formats with [`Self::Native`] replaced by what it means for a dialect.
    #[must_use]
    pub fn expand(formats: &[Self], dialect: Dialect) -> Vec<Self> {
        let own: &[Self] = match dialect {
            Dialect::Classic => &[Self::Ym, Self::Yh, Self::Restart],
            Dialect::YGeo => &[Self::Vtp, Self::Yh],
            Dialect::Split => &[Self::D3plot, Self::Yh],
            Dialect::Y3d => &[Self::Vtu, Self::Yh],
        };
        let mut expanded = formats.to_vec();
        if formats.contains(&Self::Native) {
            expanded.extend(own);
        }
        expanded
    }
}
