//! d3plot families to `.vtu` series.
//!
//! Every state becomes `<name>_<index>.vtu` with the continuum elements and, where the family
//! has joints, `<name>_joints_<index>.vtu`; `<name>.pvd` holds the series, joints as part 1.

mod cells;
mod fields;

use std::fs;
use std::path::{Path, PathBuf};

use yformat::d3plot::{FamilyReader, Notice, State};

use crate::error::ConvertError;
use crate::vtk::{PvdSeries, write_vtu};
use cells::Block;

/// What becomes of elements that the deletion table marks: broken joints.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum DeletedElements {
    /// They are left out.
    #[default]
    Drop,
    /// They stay; the cell array `deleted` is 1 for them and 0 for the others.
    Flag,
}

/// What a conversion wrote.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct D3plotReport {
    /// The collection to open in ParaView.
    pub collection: PathBuf,
    /// How many states it holds.
    pub states: usize,
    /// How many `.vtu` files there are.
    pub grids: usize,
    /// What is worth telling about the family.
    pub notices: Vec<Notice>,
}

/// Converts the family whose first file is `input` to `<name>.pvd` and its grids in `folder`.
///
/// `state_done` is told after each state how many are done and how many there are. After an error
/// no grids are left behind.
///
/// Point data: `displacement`, `velocity`, in 3D `joint force` (what the file calls
/// accelerations). Cell data: `stress`, `von Mises stress`, `Tresca stress`,
/// `principal stress 1` to `3` (largest first), `material property ID` (the index of the deck:
/// the material of the file less one). Field data: `TimeValue`, `kinetic energy`.
pub fn d3plot_to_vtu(
    input: &Path,
    folder: &Path,
    name: &str,
    deleted: DeletedElements,
    state_done: impl FnMut(usize, usize),
) -> Result<D3plotReport, ConvertError> {
    let mut written = Vec::new();
    let result = convert(input, folder, name, deleted, state_done, &mut written);
    if result.is_err() {
        // Grids without a collection would pass for the whole run.
        written.iter().for_each(|path| drop(fs::remove_file(path)));
    }
    result
}

fn convert(
    input: &Path,
    folder: &Path,
    name: &str,
    deleted: DeletedElements,
    mut state_done: impl FnMut(usize, usize),
    written: &mut Vec<PathBuf>,
) -> Result<D3plotReport, ConvertError> {
    let mut reader = FamilyReader::open(input)?;
    let layout = *reader.layout();
    if !layout.vectors[0] {
        return Err(ConvertError::Missing("coordinates"));
    }
    let [continuum, joints] = cells::split(reader.geometry())?;
    let total = reader.state_count();
    let mut series = PvdSeries::new();
    let mut state = State::default();
    for index in 0..total {
        reader.read_state(index, &mut state)?;
        let mut write = |block: &Block, part, label: &str, file: String| {
            let initial = &reader.geometry().coordinates;
            let grid = fields::grid(block, &layout, initial, &state, deleted);
            let path = folder.join(&file);
            write_vtu(&path, &grid)?;
            written.push(path);
            series.push(f64::from(state.time), part, label, file);
            Ok::<_, ConvertError>(())
        };
        write(&continuum, 0, "elements", format!("{name}_{index}.vtu"))?;
        if !joints.is_empty() {
            write(&joints, 1, "joints", format!("{name}_joints_{index}.vtu"))?;
        }
        state_done(index + 1, total);
    }
    let collection = folder.join(format!("{name}.pvd"));
    series.write(&collection)?;
    Ok(D3plotReport {
        collection,
        states: total,
        grids: series.len(),
        notices: reader.notices().to_vec(),
    })
}
