//! The command line. One file per subcommand.

mod bench;
mod check;
mod console;
mod convert;
mod deck_report;
mod exit;
mod extract;
mod interrupt;
mod keywords;
mod manual;
mod mesh;
mod plot;
mod progress;
mod resume;
mod run;
mod sweep;
mod sweep_progress;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

pub use exit::Exit;

/// Runs Munjiza's combined finite-discrete element method (FEM/DEM) on Y decks.
///
/// `ypsilon DECK` is the drop-in for the original program: it runs the deck and
/// writes its results, named after the deck, into the current directory.
#[derive(Debug, Parser)]
#[command(version, args_conflicts_with_subcommands = true, arg_required_else_help = true)]
#[command(after_help = run::help())]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    run: Option<run::RunArguments>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Run a deck
    #[command(after_help = run::help())]
    Run(run::RunArguments),
    /// Go on with a run that was interrupted, killed or ended early
    #[command(after_help = resume::HELP)]
    Resume(resume::ResumeArguments),
    /// Check a deck without running it
    #[command(after_help = check::HELP)]
    Check(check::CheckArguments),
    /// Convert results to VTU, PVD and CSV, meshes to decks, decks to other dialects
    #[command(after_help = convert::HELP)]
    Convert(convert::ConvertArguments),
    /// Draw results as contour pictures, histories and tables as curves (PNG, SVG)
    #[command(after_help = plot::HELP)]
    Plot(plot::PlotArguments),
    /// Make tables (CSV) from results: histories, lines, reactions, extremes
    #[command(after_help = extract::HELP)]
    Extract(extract::ExtractArguments),
    /// Make decks of bridges, walls, columns and blocks from parameters or scenario files
    Mesh(Box<mesh::MeshArguments>),
    /// Run a parameter study: many cases of a deck or scenario, one table
    #[command(after_help = sweep::HELP)]
    Sweep(sweep::SweepArguments),
    /// Measure speed, memory and accuracy on scenes and decks
    #[command(after_help = bench::HELP)]
    Bench(bench::BenchArguments),
    /// List the deck keywords of a dialect with their meaning
    #[command(after_help = keywords::HELP)]
    Keywords(keywords::KeywordArguments),
    /// Print what lets a shell complete the command line
    #[command(
        after_help = "Example:\n  ypsilon completions bash > ~/.local/share/bash-completion/completions/ypsilon"
    )]
    Completions(manual::CompletionArguments),
    /// Write man pages
    #[command(after_help = "Example:\n  ypsilon man --out ~/.local/share/man/man1")]
    Man(manual::ManArguments),
}

/// Parses the command line, does what it says and gives the exit code.
#[must_use]
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let exit = match (arguments.command, arguments.run) {
        (Some(Command::Run(run)), _) | (None, Some(run)) => run::main(&run),
        (Some(Command::Resume(resume)), _) => resume::main(&resume),
        (Some(Command::Check(check)), _) => check::main(&check),
        (Some(Command::Convert(convert)), _) => convert::main(&convert),
        (Some(Command::Plot(plot)), _) => plot::main(&plot),
        (Some(Command::Extract(extract)), _) => extract::main(&extract),
        (Some(Command::Mesh(mesh)), _) => mesh::main(&mesh),
        (Some(Command::Sweep(sweep)), _) => sweep::main(&sweep),
        (Some(Command::Bench(bench)), _) => bench::main(&bench),
        (Some(Command::Keywords(keywords)), _) => keywords::main(&keywords),
        (Some(Command::Completions(completions)), _) => manual::complete(&completions),
        (Some(Command::Man(man)), _) => manual::man(&man),
        (None, None) => Exit::Usage,
    };
    exit.into()
}
