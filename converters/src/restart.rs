//! Decks of the classic dialect to `.vtu`, restart decks above all.
//!
//! `<name>.vtu` shows the triangles, `<name>_joints.vtu` the joints as lines with their state:
//! fractures and intact joints as both their walls, boundaries as one edge. Values that the program
//! never set are `nan` where the deck says so. (deck.md 3.2, 3.3, 3.5)

use std::path::{Path, PathBuf};

use yformat::classic_output::{JointState, RestartDeck};
use yformat::diagnostic::Diagnostic;

use crate::error::{ConvertError, at};
use crate::vtk::{CellType, Cells, DataArray, UnstructuredGrid, write_vtu};

/// Kind of a joint that is a piece of the model's boundary.
const BOUNDARY: i64 = 1;

/// What a conversion wrote.
#[derive(Debug, Clone, PartialEq)]
pub struct RestartReport {
    /// The grids.
    pub grids: Vec<PathBuf>,
    /// Warnings and notes about the deck.
    pub diagnostics: Vec<Diagnostic>,
}

/// Converts the deck `input` into `<name>.vtu` and, if it has joints, `<name>_joints.vtu` in
/// `folder`.
///
/// Point data: `displacement` (present less initial coordinates), `velocity`, `nodal force`,
/// `nodal mass`, `boundary flag`, `node property ID`. Cell data: `material property ID`,
/// `element` and, on joints, `kind` (0 intact, 1 boundary, 2 pre-existing fracture, 3 new crack)
/// and the state of database YDJ.
///
/// # Errors
/// If the file cannot be read, is no deck of the classic dialect, or names nodes that do not exist;
/// if a grid cannot be written.
pub fn restart_to_vtu(
    input: &Path,
    folder: &Path,
    name: &str,
) -> Result<RestartReport, ConvertError> {
    let text = std::fs::read(input).map_err(at(input))?;
    let (deck, diagnostics) = RestartDeck::parse(input.display().to_string(), text)?;
    let (bodies, joints) = (bodies(&deck)?, joints(&deck)?);
    let path = folder.join(format!("{name}.vtu"));
    write_vtu(&path, &bodies)?;
    let mut grids = vec![path];
    if !joints.cells.is_empty() {
        let path = folder.join(format!("{name}_joints.vtu"));
        if let Err(error) = write_vtu(&path, &joints) {
            // bodies alone would pass for a deck without joints
            grids.iter().for_each(|path| drop(std::fs::remove_file(path)));
            return Err(error);
        }
        grids.push(path);
    }
    Ok(RestartReport { grids, diagnostics })
}

fn bodies(deck: &RestartDeck) -> Result<UnstructuredGrid, ConvertError> {
    let mut cells = Cells::new();
    let mut shown = Vec::new();
    for (element, kind) in deck.elements.kinds.iter().enumerate() {
        if *kind < 0 {
            cells.push(CellType::Triangle, &nodes::<3>(deck, element)?);
            shown.push(element);
        }
    }
    Ok(UnstructuredGrid { cell_data: element_arrays(deck, &shown), cells, ..points(deck) })
}

fn joints(deck: &RestartDeck) -> Result<UnstructuredGrid, ConvertError> {
    let mut cells = Cells::new();
    let mut shown = Vec::new();
    for (element, &kind) in deck.elements.kinds.iter().enumerate() {
        if kind < 0 {
            continue;
        }
        let [a, b, c, d] = nodes::<4>(deck, element)?;
        let walls = [[a, b], [c, d]];
        for wall in walls.iter().take(if kind == BOUNDARY { 1 } else { 2 }) {
            cells.push(CellType::Line, wall);
            shown.push(element);
        }
    }
    let mut cell_data = element_arrays(deck, &shown);
    let kinds = shown.iter().map(|&element| of(&deck.elements.kinds, element, -1));
    cell_data.push(DataArray::integer("kind", kinds.collect()));
    cell_data.extend(state_arrays(deck, &shown));
    Ok(UnstructuredGrid { cell_data, cells, ..points(deck) })
}

/// The first nodes of an element.
fn nodes<const N: usize>(deck: &RestartDeck, element: usize) -> Result<[u32; N], ConvertError> {
    let row = deck.elements.nodes.row(element).unwrap_or_default();
    let count = deck.nodes.coordinates.len();
    let mut found = [0; N];
    for (index, slot) in found.iter_mut().enumerate() {
        let node = row.get(index).copied().unwrap_or(-1);
        *slot = u32::try_from(node)
            .ok()
            .filter(|&node| (node as usize) < count)
            .ok_or(ConvertError::NoSuchDeckNode { element, node, nodes: count })?;
    }
    Ok(found)
}

/// The nodes with their data.
fn points(deck: &RestartDeck) -> UnstructuredGrid {
    let nodes = &deck.nodes;
    let initial = nodes.initial_coordinates.iter();
    let displacements: Vec<[f64; 2]> =
        nodes.coordinates.iter().zip(initial).map(|(x, x0)| [x[0] - x0[0], x[1] - x0[1]]).collect();
    let integers = |name: &str, values: &[i64]| {
        DataArray::integer(name, values.iter().map(|&value| saturated(value)).collect())
    };
    UnstructuredGrid {
        points: nodes.coordinates.iter().map(|&[x, y]| [x, y, 0.0]).collect(),
        point_data: vec![
            DataArray::plane_vector("displacement", &displacements),
            DataArray::plane_vector("velocity", &nodes.velocities),
            DataArray::plane_vector("nodal force", &nodes.forces),
            DataArray::scalar("nodal mass", nodes.masses.clone()),
            integers("boundary flag", &nodes.boundary_flags),
            integers("node property ID", &nodes.properties),
        ],
        field_data: vec![DataArray::time(deck.control.time)],
        ..UnstructuredGrid::default()
    }
}

fn element_arrays(deck: &RestartDeck, shown: &[usize]) -> Vec<DataArray> {
    let properties = shown.iter().map(|&element| of(&deck.elements.properties, element, -1));
    let elements = shown.iter().map(|&element| saturated(i64::try_from(element).unwrap_or(-1)));
    vec![
        DataArray::integer("material property ID", properties.collect()),
        DataArray::integer("element", elements.collect()),
    ]
}

/// The joint state of each line; 0 where the deck has none.
fn state_arrays(deck: &RestartDeck, shown: &[usize]) -> Vec<DataArray> {
    type Field = (&'static str, fn(&JointState) -> f64);
    const FIELDS: [Field; 19] = [
        ("initial normal stiffness", |joint| joint.initial_normal_stiffness),
        ("normal stiffness", |joint| joint.normal_stiffness),
        ("shear stiffness", |joint| joint.shear_stiffness),
        ("normal stress (compression positive)", |joint| joint.normal_stress),
        ("shear stress", |joint| joint.shear_stress),
        ("initial aperture", |joint| joint.initial_aperture),
        ("aperture", |joint| joint.aperture),
        ("hydraulic aperture", |joint| joint.hydraulic_aperture),
        ("residual aperture", |joint| joint.residual_aperture),
        ("shear displacement", |joint| joint.shear_displacement),
        ("dilation", |joint| joint.dilation),
        ("peak shear displacement", |joint| joint.peak_shear_displacement),
        ("fracture length", |joint| joint.fracture_length),
        ("roughness coefficient", |joint| joint.roughness),
        ("wall strength", |joint| joint.wall_strength),
        ("asperity angle", |joint| joint.asperity_angle),
        ("failure mode", |joint| joint.failure_mode),
        ("fluid pressure", |joint| joint.fluid_pressure),
        ("fluid entry time", |joint| joint.fluid_entry_time),
    ];
    let mut by_element = vec![None; deck.elements.kinds.len()];
    for joint in &deck.joints {
        let element = usize::try_from(joint.element).ok();
        if let Some(slot) = element.and_then(|element| by_element.get_mut(element)) {
            *slot = Some(joint);
        }
    }
    let state = |element: &usize| by_element.get(*element).copied().flatten();
    let array = |(name, field): Field| {
        let values = shown.iter().map(|element| state(element).map_or(0.0, field));
        DataArray::scalar(name, values.collect())
    };
    FIELDS.into_iter().map(array).collect()
}

fn of(values: &[i64], index: usize, absent: i64) -> i32 {
    saturated(values.get(index).copied().unwrap_or(absent))
}

fn saturated(value: i64) -> i32 {
    i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX })
}
