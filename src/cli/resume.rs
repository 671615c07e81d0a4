//! `ypsilon resume`: goes on with a run that was interrupted, killed or ended early.

use super::{Exit, console::warn, run::RunArguments};
use crate::session::{Checkpoint, CheckpointError};
use clap::Args;
use std::{
    io,
    path::{Path, PathBuf},
};
use thiserror::Error;

/// What the help shows below the options.
pub(super) const HELP: &str = "\
Examples:
  ypsilon run arch.y --out results --checkpoint-every 10000     (and the machine goes down)
  ypsilon resume results
  ypsilon resume results --deck /new/place/arch.y --threads 4

Results are as if the run had never stopped, to the last bit. Exit codes are those of `ypsilon run`.";

/// What checkpoints are called.
const ENDING: &str = ".checkpoint";
/// What those of states just before a run became unstable are called: nobody wants to go on with these
/// without saying so.
const UNSTABLE: &str = ".unstable.checkpoint";

/// Which run to go on with.
#[derive(Debug, Args)]
pub(super) struct ResumeArguments {
    /// Folder of the results with their checkpoint, or the checkpoint
    results: PathBuf,
    /// The deck, if it is not where it was; of it only MCSTEP may have changed, to make a finished run
    /// longer
    #[arg(long, value_name = "DECK")]
    deck: Option<PathBuf>,
    /// Threads to compute with; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Stop after so many more steps, whatever the deck says
    #[arg(long, value_name = "N")]
    steps: Option<u64>,
    /// Write a checkpoint after every N steps, not only at the end
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    checkpoint_every: Option<u64>,
    /// Print nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

#[derive(Debug, Error)]
enum Fault {
    #[error("cannot look into {folder}: {source}")]
    Folder { folder: PathBuf, source: io::Error },
    #[error(
        "there is no checkpoint in {folder}: runs write one with --checkpoint or --checkpoint-every N. Run the deck anew"
    )]
    None { folder: PathBuf },
    #[error("there are several checkpoints in {folder}, name one of them: {}", list(.found))]
    Several { folder: PathBuf, found: Vec<PathBuf> },
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    #[error(
        "the deck of the checkpoint was {deck}, which is not there any more: say with --deck where it is now"
    )]
    Deck { deck: PathBuf },
}

fn list(files: &[PathBuf]) -> String {
    files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>().join(", ")
}

/// The checkpoint of a folder of results.
fn checkpoint_in(folder: &Path) -> Result<PathBuf, Fault> {
    let io = |source| Fault::Folder { folder: folder.to_path_buf(), source };
    let mut found = Vec::new();
    for entry in folder.read_dir().map_err(io)? {
        let path = entry.map_err(io)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.ends_with(ENDING) && !name.ends_with(UNSTABLE) {
            found.push(path);
        }
    }
    found.sort();
    match found.as_slice() {
        [] => Err(Fault::None { folder: folder.to_path_buf() }),
        [one] => Ok(one.clone()),
        _ => Err(Fault::Several { folder: folder.to_path_buf(), found }),
    }
}

/// What `ypsilon run` is to do, and from where.
fn run_of(arguments: &ResumeArguments) -> Result<(RunArguments, Checkpoint), Fault> {
    let results = &arguments.results;
    let file = if results.is_dir() { checkpoint_in(results)? } else { results.clone() };
    let checkpoint = Checkpoint::read(&file)?;
    let deck = arguments.deck.clone().unwrap_or_else(|| checkpoint.deck_file().to_path_buf());
    if arguments.deck.is_none() && !deck.is_file() {
        return Err(Fault::Deck { deck });
    }
    let folder = match file.parent() {
        Some(folder) if folder != Path::new("") => folder.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let mut run = RunArguments::of(deck, folder);
    run.threads = arguments.threads;
    run.steps = arguments.steps;
    run.checkpoint_every = arguments.checkpoint_every;
    run.quiet = arguments.quiet;
    Ok((run, checkpoint))
}

/// Goes on with a run.
pub(super) fn main(arguments: &ResumeArguments) -> Exit {
    match run_of(arguments) {
        Ok((run, checkpoint)) => super::run::go_on(&run, checkpoint),
        Err(fault) => {
            warn(&format!("error: {fault}"));
            Exit::Input
        }
    }
}
