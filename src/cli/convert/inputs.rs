use super::{ConvertArguments, Target, kinds};
use std::{
    collections::{BTreeMap, BTreeSet},
    path::{Path, PathBuf},
};
use ypsilon_converters::{
    ConvertError,
    detect::{FileKind, detect_file},
};

/// One conversion: an input and the file that it becomes.
pub(super) struct Job {
    pub input: PathBuf,
    pub kind: FileKind,
    pub output: PathBuf,
}

/// All conversions that the arguments ask for.
#[derive(Default)]
pub(super) struct Inputs {
    pub jobs: Vec<Job>,
    /// Inputs that nothing becomes of.
    pub unusable: Vec<(PathBuf, ConvertError)>,
    /// Outputs with the inputs that they come from.
    taken: BTreeMap<PathBuf, PathBuf>,
    /// Series of which a file was met already.
    series: BTreeSet<PathBuf>,
}

impl Inputs {
    pub fn of(arguments: &ConvertArguments) -> Self {
        let mut inputs = Self::default();
        for input in &arguments.inputs {
            if input.is_dir() {
                match files_in(input) {
                    Ok(files) => files.iter().for_each(|file| inputs.add(file, true, arguments)),
                    Err(source) => {
                        let error = ConvertError::Io { path: input.clone(), source };
                        inputs.unusable.push((input.clone(), error));
                    }
                }
            } else {
                inputs.add(input, false, arguments);
            }
        }
        inputs
    }

    /// Adds a file. Of a folder only those are meant that can be converted to what is asked for.
    fn add(&mut self, input: &Path, of_folder: bool, arguments: &ConvertArguments) {
        let kind = match detect_file(input) {
            Ok(FileKind::Unknown) if of_folder => return,
            Ok(kind) => kind,
            Err(error) => return self.unusable.push((input.to_path_buf(), error)),
        };
        // decks lie beside results; only those of earlier runs are results themselves
        if of_folder && kind == FileKind::Deck && arguments.to != Some(Target::Deck) {
            return;
        }
        let output = match kinds::output(input, kind, arguments) {
            Ok(output) => output,
            Err(_) if of_folder => return,
            Err(error) => return self.unusable.push((input.to_path_buf(), error)),
        };
        if matches!(kind, FileKind::VtkSeries | FileKind::Ym) {
            // Each file of a series stands for all of them.
            let folder = input.parent().unwrap_or(Path::new(""));
            let series = folder.join(output.file_name().unwrap_or_default());
            if !self.series.insert(series) {
                return;
            }
        }
        match self.taken.get(&output) {
            Some(other) if other == input => {}
            Some(other) => {
                let error = ConvertError::SameOutput {
                    inputs: [other.clone(), input.to_path_buf()],
                    output,
                };
                self.unusable.push((input.to_path_buf(), error));
            }
            None => {
                self.taken.insert(output.clone(), input.to_path_buf());
                self.jobs.push(Job { input: input.to_path_buf(), kind, output });
            }
        }
    }
}

/// The files in a folder, in order of their names.
fn files_in(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in folder.read_dir()? {
        let path = entry?.path();
        if path.is_file() {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// The error that an input of this kind does not become what is asked for.
pub(super) fn unsuitable(input: &Path, becomes: &'static str, to: Target) -> ConvertError {
    let to = match to {
        Target::Vtu => "vtu",
        Target::Pvd => "pvd",
        Target::Csv => "csv",
        Target::Deck => "deck",
    };
    ConvertError::Unsuitable { path: input.to_path_buf(), becomes, to }
}
