//! `ypsilon convert`: what each input becomes is decided by what it holds.

mod inputs;
mod kinds;
mod progress;

use super::{
    Exit,
    console::{say, warn},
    run::parse_dialect,
};
use clap::{Args, ValueEnum};
use inputs::Inputs;
use std::path::{Path, PathBuf};
use yformat::dialect::Dialect;
use ypsilon_converters::ConvertError;

/// What becomes of what, as the help shows it.
pub(super) const HELP: &str = "\
Files are recognised by what they hold, not by their names:
  d3plot family         -> VTU files and a PVD collection
  .ym snapshots         -> VTU files (bodies, cracks, acoustic sources) and a PVD
                           collection; scales come from the deck beside them (--deck)
  .yh history           -> CSV table
  restart deck (classic)-> VTU files of its bodies and joints
  VTK files of Y-Geo    -> PVD collection of all files of the run; with --to vtu also
                           copies that show points without cells
  Gmsh mesh (.msh)      -> deck of the split dialect, complete but for the materials
  deck, with --to deck  -> deck of another dialect (--dialect)
Of folders all files of these kinds are converted.

Examples:
  ypsilon convert results/arch --out vtu
  ypsilon convert old-results --out vtu --deck old/wall.y
  ypsilon convert arch.yh0
  ypsilon convert plate.msh --out decks
  ypsilon convert arch.y --to deck --dialect classic --out decks

Exit codes:
  0    everything is converted
  1    an input cannot be converted; the others are
  2    the command line is wrong
  3    a file cannot be written";

/// What to convert.
#[derive(Debug, Args)]
pub(super) struct ConvertArguments {
    /// Files and folders: results, meshes, decks
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    /// What to convert to; without it what suits the input
    #[arg(long, value_enum, value_name = "KIND")]
    to: Option<Target>,
    /// Folder of the converted files, made if it does not exist
    #[arg(long = "out", short = 'o', value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// Dialect of decks that are made from decks: split, classic or y-geo
    #[arg(long, value_name = "NAME", value_parser = parse_dialect, default_value = "split")]
    dialect: Dialect,
    /// Deck that `.ym` snapshots come from, if it does not lie beside them
    #[arg(long, value_name = "FILE")]
    deck: Option<PathBuf>,
    /// Keep deleted elements (broken joints), flagged, instead of dropping them
    #[arg(long)]
    keep_deleted: bool,
}

/// What inputs are converted to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Target {
    /// Grids for ParaView, with a collection
    Vtu,
    /// A collection for ParaView
    Pvd,
    /// A table
    Csv,
    /// An input deck
    Deck,
}

/// What became of an input.
struct Made {
    /// The file to open.
    file: PathBuf,
    /// What is worth telling.
    notes: Vec<String>,
    /// Parts of the input that could not be converted.
    broken: Vec<ConvertError>,
}

/// Converts each input to what its content asks for.
pub(super) fn main(arguments: &ConvertArguments) -> Exit {
    if let Err(error) = std::fs::create_dir_all(&arguments.folder) {
        warn(&format!("error: cannot make {}: {error}", arguments.folder.display()));
        return Exit::Output;
    }
    let mut exit = Exit::Done;
    let fail = |exit: &mut Exit, error: &ConvertError, input: &Path| {
        warn(&format!("error: {}", told(error, input)));
        *exit = match exit {
            Exit::Output => Exit::Output,
            _ => exit_of(error, input, &arguments.folder),
        };
    };
    let inputs = Inputs::of(arguments);
    for (input, error) in &inputs.unusable {
        fail(&mut exit, error, input);
    }
    let bar = progress::Bar::new(inputs.jobs.len());
    for job in &inputs.jobs {
        bar.starts(&job.input);
        let result = kinds::convert(job, arguments, &bar);
        bar.suspend(|| match result {
            Ok(made) => {
                for note in &made.notes {
                    warn(&format!("warning: {}: {note}", job.input.display()));
                }
                for error in &made.broken {
                    fail(&mut exit, error, &job.input);
                }
                say(&format!("{} -> {}", job.input.display(), made.file.display()));
            }
            Err(error) => fail(&mut exit, &error, &job.input),
        });
        bar.done();
    }
    bar.finish();
    exit
}

/// The message of an error, with the input where it does not name it.
fn told(error: &ConvertError, input: &Path) -> String {
    let (message, input) = (error.to_string(), input.display().to_string());
    if message.contains(&input) { message } else { format!("{input}: {message}") }
}

/// A file that the system refuses is an output if it lies in the folder of the outputs and is not
/// the input.
fn exit_of(error: &ConvertError, input: &Path, folder: &Path) -> Exit {
    match error {
        ConvertError::Io { path, .. } if path.starts_with(folder) && path != input => Exit::Output,
        _ => Exit::Input,
    }
}
