//! The VTK files of Y-Geo to time series (spec `outputs.md` 5).
//!
//! Y-Geo writes up to seven files per output step and no collection: `wall.y_300.vtp` (triangles),
//! `wall.y_broken_joints_300.vtp`, `wall.y_acoustic_300.vtu` and so on. VTK reads them as they
//! are, so a [`Series`] needs a `.pvd` collection only. Mended copies in our own form also show
//! what has points but no cells (acoustic events, principal directions), which ParaView does not
//! draw otherwise, and know their time.

mod name;
mod read;

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use yformat::database::Database;
use yformat::deck::Deck;

use crate::error::{ConvertError, at};
use crate::vtk::{DataArray, PvdSeries, UnstructuredGrid, write_vtu};
pub use name::{SeriesKind, SeriesName};
use read::{check_complete, read_grid};

/// All files of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Series {
    /// The folder that they lie in.
    pub folder: PathBuf,
    /// What their names begin with: the name of the deck.
    pub family: String,
    /// The files by step and kind.
    pub files: BTreeMap<(u64, SeriesKind), PathBuf>,
}

/// What becomes of the files of a series.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum SeriesForm {
    /// The collection names them where they are.
    #[default]
    Link,
    /// They are written anew as `.vtu` files beside the collection.
    Copy,
}

/// What a conversion wrote.
#[derive(Debug)]
pub struct SeriesReport {
    /// The collection to open in ParaView.
    pub collection: PathBuf,
    /// How many files it names.
    pub files: usize,
    /// Whether the times are those of the deck; otherwise they are step numbers.
    pub has_times: bool,
    /// Files that cannot be read and are left out.
    pub broken: Vec<ConvertError>,
}

/// The series that `input`, one of its files, belongs to: all files of the folder whose names fit.
///
/// # Errors
/// If the name has no step number, or the folder cannot be read.
pub fn series_of(input: &Path) -> Result<Series, ConvertError> {
    let name = SeriesName::of(input)
        .ok_or_else(|| ConvertError::SeriesName { path: input.to_path_buf() })?;
    let folder = match input.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let mut files = BTreeMap::new();
    for entry in folder.read_dir().map_err(at(&folder))? {
        let path = entry.map_err(at(&folder))?.path();
        if let Some(other) = SeriesName::of(&path).filter(|other| other.family == name.family) {
            files.insert((other.step, other.kind), path);
        }
    }
    Ok(Series { folder, family: name.family, files })
}

/// Writes `<family>.pvd` into `folder`: each kind of file is a part, the time is that of the deck
/// where the deck lies beside the files, otherwise the step number.
///
/// `file_done` is told after each file how many are done and how many there are. Files that cannot
/// be read are left out and reported.
///
/// # Errors
/// If nothing can be read, or a file cannot be written.
pub fn series_to_pvd(
    series: &Series,
    folder: &Path,
    form: SeriesForm,
    mut file_done: impl FnMut(usize, usize),
) -> Result<SeriesReport, ConvertError> {
    let clock = Clock::of_deck(&series.folder.join(&series.family));
    let mut collection = PvdSeries::new();
    let mut broken = Vec::new();
    let way = match form {
        SeriesForm::Link => way_between(folder, &series.folder).map_err(at(&series.folder))?,
        SeriesForm::Copy => String::new(),
    };
    for (index, (&(step, kind), path)) in series.files.iter().enumerate() {
        let time = clock.map_or(step as f64, |clock| clock.time(step));
        match read(path, form) {
            Ok((name, None)) => {
                collection.push(time, kind.part(), kind.label(), format!("{way}{name}"));
            }
            Ok((name, Some(mut grid))) => {
                grid.field_data.push(DataArray::time(time));
                let name = Path::new(&name).with_extension("vtu").to_string_lossy().into_owned();
                match write_vtu(&folder.join(&name), &grid) {
                    Ok(()) => collection.push(time, kind.part(), kind.label(), name),
                    Err(wrong @ ConvertError::ArrayLength { .. }) => broken
                        .push(ConvertError::Vtk { path: path.clone(), message: wrong.to_string() }),
                    Err(error) => return Err(error),
                }
            }
            Err(error) => broken.push(error),
        }
        file_done(index + 1, series.files.len());
    }
    if collection.is_empty()
        && let Some(first) = broken.pop()
    {
        return Err(first);
    }
    let path = folder.join(format!("{}.pvd", series.family));
    collection.write(&path)?;
    let (files, has_times) = (collection.len(), clock.is_some());
    Ok(SeriesReport { collection: path, files, has_times, broken })
}

/// Name of a file and, where it is to be written anew, what it shows.
fn read(path: &Path, form: SeriesForm) -> Result<(String, Option<UnstructuredGrid>), ConvertError> {
    let text = std::fs::read(path).map_err(at(path))?;
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let wrong = |message| ConvertError::Vtk { path: path.to_path_buf(), message };
    let grid = match form {
        SeriesForm::Link => check_complete(&text).map(|()| None),
        SeriesForm::Copy => read_grid(&text).map(Some),
    };
    Ok((name, grid.map_err(wrong)?))
}

/// How times follow from steps.
#[derive(Debug, Clone, Copy)]
struct Clock {
    start: f64,
    step: f64,
}

impl Clock {
    /// That of a deck, if it can be read.
    fn of_deck(path: &Path) -> Option<Self> {
        let deck = Deck::read(path).ok()?.deck;
        let mut database = Database::new(deck.dialect());
        for item in deck.stages().first()?.items.clone() {
            let _ = database.apply(&deck, item);
        }
        let _ = database.given("YDC/DCSTEC")?;
        let clock = Clock { start: database.real("YDC/DCTIME"), step: database.real("YDC/DCSTEC") };
        (clock.start.is_finite() && clock.step.is_finite() && clock.step > 0.0).then_some(clock)
    }

    fn time(self, step: u64) -> f64 {
        self.start + step as f64 * self.step
    }
}

/// The way from one folder to another as a prefix of file names: empty or ending in `/`.
fn way_between(from: &Path, to: &Path) -> std::io::Result<String> {
    let (from, to) = (from.canonicalize()?, to.canonicalize()?);
    let common =
        from.components().zip(to.components()).take_while(|(one, other)| one == other).count();
    let mut way = String::new();
    if common == 0 {
        way.push_str(&to.to_string_lossy());
        way.push('/');
        return Ok(way);
    }
    for _ in from.components().skip(common) {
        way.push_str("../");
    }
    for component in to.components().skip(common) {
        if let Component::Normal(name) = component {
            way.push_str(&name.to_string_lossy());
            way.push('/');
        }
    }
    Ok(way)
}
