use super::{Exit, run::parse_dialect};
use clap::Args;
use std::io::Write;
use yformat::{dialect::Dialect, keywords};

/// What the help shows below the options.
pub(super) const HELP: &str = "\
Examples:
  ypsilon keywords D1PEPE
  ypsilon keywords --dialect y-geo viscosity
  ypsilon keywords --dialect classic > keywords.md";

/// Which keywords to list.
#[derive(Debug, Args)]
pub(super) struct KeywordArguments {
    /// Dialect
    #[arg(long, value_name = "NAME", value_parser = parse_dialect, default_value = "split")]
    dialect: Dialect,
    /// Only keywords whose path, unit or meaning contains this text
    filter: Option<String>,
}

/// Prints the keyword tables as Markdown.
pub(super) fn main(arguments: &KeywordArguments) -> Exit {
    let text = keywords::reference(arguments.dialect, arguments.filter.as_deref());
    match std::io::stdout().write_all(text.as_bytes()) {
        Ok(()) => Exit::Done,
        Err(_) => Exit::Output,
    }
}
