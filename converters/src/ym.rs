//! `.ym` snapshots of the classic dialect to `.vtu` series.
//!
//! Every snapshot becomes `<name>_<number>.vtu` with the triangles and, from the first snapshot on
//! that has any, `<name>_cracks_<number>.vtu` with fractures and model boundaries as lines and
//! `<name>_acoustic_<number>.vtu` with acoustic sources as vertices. `<name>.pvd` holds the series:
//! triangles are part 0, cracks 1, acoustic sources 2.
//!
//! This does the work of the older converters `m2vtu` and `m2vtu_crack`. What they offered is here
//! under names that say what it is, as cell data:
//!
//! | older name | here | difference |
//! |---|---|---|
//! | `Velocity vector` | `velocity` | |
//! | `Stress tensor` | `Cauchy stress` | tension positive, as in all results of Ypsilon; older: compression |
//! | `Sigma1`, `Sigma3` | `sigma1 (compression positive)`, `sigma3 (compression positive)` | in the plane only |
//! | `Mean stress` | `mean stress (compression positive)` | |
//! | `Differential stress` | `differential stress` | |
//! | `Sigma1 Vectors` | `sigma1 vector (compression positive)` | zero where the out-of-plane stress 0 is the largest; sign arbitrary |
//! | `Sigma3 vectors` | `sigma3 vector (compression positive)` | zero where it is the smallest; sign arbitrary |
//! | `Contact force vectors` | `contact force` | 0 for triangles that have none, where the older one repeats the triangle before |
//! | (crack) `Failure mode` | `failure mode` | -1 on boundaries |
//! | (crack) `Fracture type` | `fracture type` | 0 tension or pre-existing, 1 shear, -1 boundary |
//! | (crack) `Contact force` | `contact force` | of boundaries; 0 on fractures |
//! | (crack) `Shear displacement` | `legacy shear displacement` | what the older one gave: 0.05 times the magnitude of the coded **dilation** |
//!
//! New are `damage`, and on cracks `shear displacement` and `dilation` (m), `aperture` and
//! `hydraulic aperture` (m; closed ones show the scale `DCSIZA`), `normal stress (compression
//! positive)`, `shear stress` (Pa) and `sliding force` (N). Boundaries have 0 there.
//!
//! Joints and sources, which the program writes once per set of joints, appear once. Points are
//! double precision and belong to one cell each; the older centroids are left out.
//!
//! Zeros come back as -1.5e-8 of their scale (with four digits), see [`yformat::ym`].

mod acoustic;
mod bodies;
mod cracks;
mod deck;
mod notice;
mod repeats;
mod series;

use std::path::{Path, PathBuf};

use yformat::ym::{RecordKind, Snapshot};

use crate::error::{ConvertError, at};
use crate::vtk::{DataArray, PvdSeries, UnstructuredGrid, write_vtu};
use repeats::without_repeats;

pub use deck::{SeriesDeck, SnapshotTimes};
pub use notice::YmNotice;
pub use series::YmSeries;

/// What a conversion wrote.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct YmReport {
    /// The collection to open in ParaView.
    pub collection: PathBuf,
    /// How many snapshots it holds.
    pub snapshots: usize,
    /// How many `.vtu` files there are.
    pub grids: usize,
    /// The deck that the scales and times are from.
    pub deck: Option<PathBuf>,
    /// What is worth telling about the series.
    pub notices: Vec<YmNotice>,
}

/// Converts the series that the snapshot `input` belongs to into `<name>.pvd` and its grids in
/// `folder`.
///
/// The scales are those of `deck`, or of the deck found beside the snapshots; without one all are
/// 1, apertures relative to 1e-7 m and times are snapshot numbers, and a notice says so. `done` is
/// told after each snapshot how many are converted and how many there are.
///
/// # Errors
/// If `input` is not called like a snapshot, if a file cannot be read or written, or if a snapshot
/// is damaged. No grids are left behind then: without a collection they would pass for the whole
/// run.
pub fn ym_to_vtu(
    input: &Path,
    deck: Option<&Path>,
    folder: &Path,
    name: &str,
    mut done: impl FnMut(usize, usize),
) -> Result<YmReport, ConvertError> {
    let series = YmSeries::find(input, deck)?;
    let mut notices = series.notices.clone();
    let about = match &series.deck {
        Some(path) => SeriesDeck::read(path)?,
        None => SeriesDeck::default(),
    };
    notices.extend(about.notices.iter().cloned());
    let mut output = Output {
        folder,
        name,
        collection: PvdSeries::new(),
        shown: [true, false, false],
        written: Vec::new(),
    };
    let result = output.write_series(&series, &about, &mut notices, &mut done);
    if result.is_err() {
        output.written.iter().for_each(|path| drop(std::fs::remove_file(path)));
    }
    Ok(YmReport {
        collection: result?,
        snapshots: series.snapshots.len(),
        grids: output.collection.len(),
        deck: series.deck,
        notices,
    })
}

/// Where the grids go.
struct Output<'a> {
    folder: &'a Path,
    name: &'a str,
    collection: PvdSeries,
    /// Whether triangles, cracks and sources have appeared so far.
    shown: [bool; 3],
    /// The grids so far.
    written: Vec<PathBuf>,
}

impl Output<'_> {
    /// Writes all snapshots and the collection; gives the collection's name.
    fn write_series(
        &mut self,
        series: &YmSeries,
        about: &SeriesDeck,
        notices: &mut Vec<YmNotice>,
        done: &mut impl FnMut(usize, usize),
    ) -> Result<PathBuf, ConvertError> {
        for (index, (number, path)) in series.snapshots.iter().enumerate() {
            let text = std::fs::read(path).map_err(at(path))?;
            let snapshot = Snapshot::parse(path.display().to_string(), &text)?;
            if let Some(line) = snapshot.truncated {
                notices.push(YmNotice::Truncated { path: path.clone(), line });
            }
            self.write(*number, &snapshot, about)?;
            done(index + 1, series.snapshots.len());
        }
        let collection = self.folder.join(format!("{}.pvd", self.name));
        self.collection.write(&collection)?;
        Ok(collection)
    }

    fn write(
        &mut self,
        number: u64,
        snapshot: &Snapshot,
        about: &SeriesDeck,
    ) -> Result<(), ConvertError> {
        let records = &snapshot.records;
        let of = |kinds: &[RecordKind]| -> Vec<_> {
            records.iter().filter(|record| kinds.contains(&record.kind())).copied().collect()
        };
        let triangles = of(&[RecordKind::Triangle, RecordKind::TriangleWithoutForce]);
        let joints = of(&[RecordKind::FractureJoint, RecordKind::BoundaryJoint]);
        let sources = of(&[RecordKind::AcousticSource]);
        let scales = &about.scales;
        let grids = [
            ("triangles", "", bodies::grid(&triangles, scales)),
            ("cracks", "_cracks", cracks::grid(without_repeats(&joints), scales)),
            ("acoustic sources", "_acoustic", acoustic::grid(without_repeats(&sources), scales)),
        ];
        let time = about.time(number);
        for (part, (label, infix, mut grid)) in grids.into_iter().enumerate() {
            if let Some(shown) = self.shown.get_mut(part) {
                *shown |= !grid.cells.is_empty();
                if !*shown {
                    continue;
                }
            }
            grid.field_data.push(DataArray::time(time));
            self.write_part(
                time,
                part,
                label,
                format!("{}{infix}_{number}.vtu", self.name),
                &grid,
            )?;
        }
        Ok(())
    }

    fn write_part(
        &mut self,
        time: f64,
        part: usize,
        label: &str,
        file: String,
        grid: &UnstructuredGrid,
    ) -> Result<(), ConvertError> {
        let path = self.folder.join(&file);
        write_vtu(&path, grid)?;
        self.written.push(path);
        self.collection.push(time, part as u32, label, file);
        Ok(())
    }
}
