use super::{
    Exit,
    console::{say, warn},
};
use clap::Args;
use indicatif::ProgressBar;
use std::path::{Path, PathBuf};
use ypsilon_converters::{
    ConvertError,
    d3plot::{DeletedElements, d3plot_to_vtu},
    detect::{FileKind, detect_file},
    history::histories_to_csv,
};

/// What to convert.
#[derive(Debug, Args)]
pub(super) struct ConvertArguments {
    /// Result files: first files of d3plot families, `.yh` histories
    #[arg(required = true)]
    inputs: Vec<PathBuf>,
    /// Folder of the converted files, made if it does not exist
    #[arg(long = "out", short = 'o', value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// Keep deleted elements (broken joints), flagged, instead of dropping them
    #[arg(long)]
    keep_deleted: bool,
}

/// Converts each input to what its content asks for.
pub(super) fn main(arguments: &ConvertArguments) -> Exit {
    if let Err(error) = std::fs::create_dir_all(&arguments.folder) {
        warn(&format!("error: cannot make {}: {error}", arguments.folder.display()));
        return Exit::Output;
    }
    let mut exit = Exit::Done;
    for input in &arguments.inputs {
        match convert(input, arguments) {
            Ok(made) => say(&format!("{} -> {}", input.display(), made.display())),
            Err(error) => {
                warn(&format!("error: {error}"));
                exit = Exit::Input;
            }
        }
    }
    exit
}

fn convert(input: &Path, arguments: &ConvertArguments) -> Result<PathBuf, ConvertError> {
    let name = input.file_name().unwrap_or_default().to_string_lossy().into_owned();
    match detect_file(input)? {
        FileKind::D3plot => {
            let deleted =
                if arguments.keep_deleted { DeletedElements::Flag } else { DeletedElements::Drop };
            let bar = ProgressBar::no_length();
            let report = d3plot_to_vtu(input, &arguments.folder, &name, deleted, |done, total| {
                bar.set_length(total as u64);
                bar.set_position(done as u64);
            })?;
            bar.finish_and_clear();
            for notice in &report.notices {
                warn(&format!("warning: {}: {notice}", input.display()));
            }
            Ok(report.collection)
        }
        FileKind::History => {
            let output = arguments.folder.join(format!("{name}.csv"));
            let _ = histories_to_csv(&[input], &output)?;
            Ok(output)
        }
        FileKind::Unknown => Err(ConvertError::Unrecognised { path: input.to_path_buf() }),
    }
}
