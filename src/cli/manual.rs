//! What a package of the program installs beside it: man pages and completions of shells.

use super::{Arguments, Exit, console::warn};
use clap::{Args, CommandFactory};
use clap_complete::Shell;
use std::{
    io::{self, Write},
    path::PathBuf,
};

/// Which shell.
#[derive(Debug, Args)]
pub(super) struct CompletionArguments {
    /// Shell
    #[arg(value_enum)]
    shell: Shell,
}

/// Where the pages go.
#[derive(Debug, Args)]
pub(super) struct ManArguments {
    /// Folder for the pages; it is made if it is not there
    #[arg(long = "out", value_name = "DIR", default_value = "man1")]
    folder: PathBuf,
}

/// Prints the completions of a shell.
pub(super) fn complete(arguments: &CompletionArguments) -> Exit {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut Arguments::command(), "ypsilon", &mut text);
    match io::stdout().write_all(&text) {
        Ok(()) => Exit::Done,
        Err(_) => Exit::Output,
    }
}

/// Writes a page for the program and one for each of its subcommands.
pub(super) fn man(arguments: &ManArguments) -> Exit {
    let written = std::fs::create_dir_all(&arguments.folder)
        .and_then(|()| clap_mangen::generate_to(Arguments::command(), &arguments.folder));
    match written {
        Ok(()) => Exit::Done,
        Err(error) => {
            warn(&format!(
                "error: cannot write man pages to {}: {error}",
                arguments.folder.display()
            ));
            Exit::Output
        }
    }
}
