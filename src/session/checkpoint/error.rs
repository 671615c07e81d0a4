use crate::simulation::StateFault;
use std::{io, path::PathBuf};
use thiserror::Error;

/// Why a run cannot go on from a checkpoint.
#[derive(Debug, Error)]
pub enum CheckpointError {
    /// The file cannot be read.
    #[error("cannot read the checkpoint {path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The file is something else.
    #[error(
        "{path} is no checkpoint of Ypsilon; expected DECK.checkpoint as `--checkpoint` writes it"
    )]
    NotOne {
        /// The file.
        path: PathBuf,
    },
    /// Another version of Ypsilon has written it.
    #[error(
        "{path} was written by Ypsilon {found} (format {format}), this is {} (format {}): \
         results of other versions can differ in their last bits. Go on with that version, or run the deck anew",
        env!("CARGO_PKG_VERSION"),
        super::file::FORMAT
    )]
    Version {
        /// The file.
        path: PathBuf,
        /// Version of the program.
        found: String,
        /// Version of the file format.
        format: u32,
    },
    /// The file ends too early or was changed.
    #[error(
        "the checkpoint {path} is damaged: {reason}. Run the deck anew, or go on from another checkpoint"
    )]
    Damaged {
        /// The file.
        path: PathBuf,
        /// In what way.
        reason: String,
    },
    /// The deck is not the one of the checkpoint.
    #[error(
        "{deck} is not the deck of the checkpoint, or has been changed since (its included files among it): \
         only MCSTEP may change. Run it anew"
    )]
    OtherDeck {
        /// The deck.
        deck: PathBuf,
    },
    /// A stage that is over has got another end.
    #[error(
        "stage {stage} of the deck, which is over, ended with MCSTEP {was} and says {now} now: \
         only MCSTEP of the present stage and of later ones may change. Set it back, or run the deck anew"
    )]
    EarlierStage {
        /// Number of the stage, from 1.
        stage: usize,
        /// MCSTEP of the run.
        was: i64,
        /// MCSTEP of the deck now.
        now: i64,
    },
    /// The deck ends before the checkpoint.
    #[error(
        "the checkpoint is at step {step}, but MCSTEP of the deck is {end} now; expected {step} or more"
    )]
    Passed {
        /// Step of the checkpoint.
        step: u64,
        /// MCSTEP of the deck.
        end: u64,
    },
    /// The files asked for are not those of the earlier run.
    #[error(
        "the run of the checkpoint wrote other kinds of files (it wrote {was}): \
         leave --formats and --states out to go on with the same"
    )]
    OtherFormats {
        /// Kinds that the run wrote.
        was: String,
    },
    /// The state cannot be that of the deck.
    #[error("the checkpoint cannot be used: {0}")]
    State(#[from] StateFault),
}
