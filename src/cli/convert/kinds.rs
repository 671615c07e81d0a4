//! The kinds of inputs: what each becomes, under which name, and how. A new kind gets an arm in
//! [`output`] and one in [`convert`].

use super::{
    ConvertArguments, Made, Target,
    inputs::{Job, unsuitable},
    progress::Bar,
};
use std::path::{Path, PathBuf};
use ypsilon_converters::{
    ConvertError,
    d3plot::{DeletedElements, d3plot_to_vtu},
    detect::FileKind,
    dialects::deck_to_dialect,
    gmsh::gmsh_to_deck,
    history::histories_to_csv,
    restart::restart_to_vtu,
    vtk_series::{SeriesForm, SeriesName, series_of, series_to_pvd},
    ym::{YmSeries, ym_to_vtu},
};

/// The file that an input becomes; an error if it does not become what is asked for.
pub(super) fn output(
    input: &Path,
    kind: FileKind,
    arguments: &ConvertArguments,
) -> Result<PathBuf, ConvertError> {
    let named = |name: &dyn AsRef<std::ffi::OsStr>, ending: &str| {
        let mut name = name.as_ref().to_owned();
        name.push(ending);
        arguments.folder.join(name)
    };
    let (name, stem) =
        (input.file_name().unwrap_or_default(), input.file_stem().unwrap_or_default());
    match (kind, arguments.to) {
        (FileKind::D3plot, None | Some(Target::Pvd | Target::Vtu)) => Ok(named(&name, ".pvd")),
        (FileKind::D3plot, Some(to)) => Err(unsuitable(input, "vtu and pvd", to)),
        (FileKind::History, None | Some(Target::Csv)) => Ok(named(&name, ".csv")),
        (FileKind::History, Some(to)) => Err(unsuitable(input, "csv", to)),
        (FileKind::VtkSeries, None | Some(Target::Pvd | Target::Vtu)) => {
            let series = SeriesName::of(input)
                .ok_or_else(|| ConvertError::SeriesName { path: input.to_path_buf() })?;
            Ok(named(&series.family, ".pvd"))
        }
        (FileKind::VtkSeries, Some(to)) => Err(unsuitable(input, "pvd and vtu", to)),
        (FileKind::Ym, None | Some(Target::Pvd | Target::Vtu)) => {
            let series = YmSeries::find(input, arguments.deck.as_deref())?;
            Ok(named(&series.prefix, ".pvd"))
        }
        (FileKind::Ym, Some(to)) => Err(unsuitable(input, "pvd and vtu", to)),
        (FileKind::RestartDeck, None | Some(Target::Pvd | Target::Vtu)) => Ok(named(&stem, ".vtu")),
        (FileKind::Gmsh, None | Some(Target::Deck)) => Ok(named(&stem, ".y")),
        (FileKind::Gmsh, Some(to)) => Err(unsuitable(input, "deck", to)),
        (FileKind::Deck | FileKind::RestartDeck, Some(Target::Deck)) => {
            Ok(named(&stem, &format!("_{}.y", arguments.dialect)))
        }
        (FileKind::Deck, Some(Target::Pvd | Target::Vtu)) => Ok(named(&stem, ".vtu")),
        (FileKind::Deck | FileKind::RestartDeck, Some(to)) => {
            Err(unsuitable(input, "deck and vtu", to))
        }
        (FileKind::Deck, None) => Err(ConvertError::DeckAlone { path: input.to_path_buf() }),
        (FileKind::Unknown, _) => Err(ConvertError::Unrecognised { path: input.to_path_buf() }),
    }
}

/// Converts an input.
pub(super) fn convert(
    job: &Job,
    arguments: &ConvertArguments,
    bar: &Bar,
) -> Result<Made, ConvertError> {
    let file = job.output.clone();
    let made = |notes| Ok(Made { file: file.clone(), notes, broken: Vec::new() });
    match job.kind {
        FileKind::D3plot => {
            let deleted =
                if arguments.keep_deleted { DeletedElements::Flag } else { DeletedElements::Drop };
            let name = job.input.file_name().unwrap_or_default().to_string_lossy();
            let report =
                d3plot_to_vtu(&job.input, &arguments.folder, &name, deleted, bar.counter())?;
            made(report.notices.iter().map(ToString::to_string).collect())
        }
        FileKind::History => {
            let report = histories_to_csv(&[&job.input], &file)?;
            let cut = || "the last line has no line end: it may be cut short".to_owned();
            made(report.unterminated.iter().map(|_| cut()).collect())
        }
        FileKind::VtkSeries => {
            let form = match arguments.to {
                Some(Target::Vtu) => SeriesForm::Copy,
                _ => SeriesForm::Link,
            };
            let series = series_of(&job.input)?;
            let report = series_to_pvd(&series, &arguments.folder, form, bar.counter())?;
            let mut notes = Vec::new();
            if !report.has_times {
                notes.push(format!(
                    "times are step numbers: the deck {} does not lie beside the files",
                    series.family
                ));
            }
            Ok(Made { file, notes, broken: report.broken })
        }
        FileKind::Gmsh => made(gmsh_to_deck(&job.input, &file)?),
        FileKind::Ym => {
            let series = YmSeries::find(&job.input, arguments.deck.as_deref())?;
            let report = ym_to_vtu(
                &job.input,
                arguments.deck.as_deref(),
                &arguments.folder,
                &series.prefix,
                bar.counter(),
            )?;
            made(report.notices.iter().map(ToString::to_string).collect())
        }
        FileKind::Deck | FileKind::RestartDeck if arguments.to != Some(Target::Deck) => {
            let stem = job.input.file_stem().unwrap_or_default().to_string_lossy();
            let report = restart_to_vtu(&job.input, &arguments.folder, &stem)?;
            made(report.diagnostics.iter().map(ToString::to_string).collect())
        }
        FileKind::Deck | FileKind::RestartDeck => {
            made(deck_to_dialect(&job.input, &file, arguments.dialect)?)
        }
        FileKind::Unknown => Err(ConvertError::Unrecognised { path: job.input.clone() }),
    }
}
