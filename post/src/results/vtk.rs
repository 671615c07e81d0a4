//! From grids of `.vtu` files to frames.

use ypsilon_converters::stress_measures::{SymmetricTensor, plane};
use ypsilon_converters::vtk::{CellType, Cells, DataArray, UnstructuredGrid, Values};

use super::frame::{Frame, Joint, JointState};
use crate::vectors::middle;

/// 3 for a grid with solids, otherwise 2.
pub(super) fn dimension(grid: &UnstructuredGrid) -> usize {
    let is_solid = |kind: Option<CellType>| {
        use CellType::{Hexahedron, QuadraticTetra, Tetra, Wedge};
        matches!(kind, Some(Tetra | QuadraticTetra | Hexahedron | Wedge))
    };
    if cells(&grid.cells).any(|(kind, _)| is_solid(kind)) { 3 } else { 2 }
}

/// The time of a grid, s; 0 if it does not tell.
pub(super) fn time(grid: &UnstructuredGrid) -> f64 {
    field(grid, "TimeValue").unwrap_or(0.0)
}

/// A frame with the bodies of a grid: its triangles, or its tetrahedra.
pub(super) fn bodies<const D: usize, const C: usize>(
    grid: &UnstructuredGrid,
) -> Result<Frame<D, C>, String> {
    let mut elements = Vec::with_capacity(grid.cells.len());
    let mut edge_nodes = Vec::new();
    let mut shown = Vec::with_capacity(grid.cells.len());
    for (index, (kind, nodes)) in cells(&grid.cells).enumerate() {
        let corners = match (D, kind) {
            (2, Some(CellType::Triangle)) | (3, Some(CellType::Tetra)) => nodes,
            (3, Some(CellType::QuadraticTetra)) => {
                let (corners, edges) = nodes.split_at_checked(C).unwrap_or((&[], &[]));
                edge_nodes.resize(elements.len(), None);
                edge_nodes
                    .push(edges.try_into().ok().map(|edges: [i64; 6]| edges.map(|n| n as u32)));
                corners
            }
            (3, Some(CellType::Hexahedron | CellType::Wedge)) => {
                return Err("the grid has solids that are no tetrahedra; expected tetrahedra \
                            alone"
                    .to_owned());
            }
            _ => continue,
        };
        if let Ok(corners) = <[i64; C]>::try_from(corners) {
            elements.push(corners.map(|n| n as u32));
            shown.push(index);
        }
    }
    if !edge_nodes.is_empty() {
        edge_nodes.resize(elements.len(), None);
    }
    let of_points = |name| vectors(&grid.point_data, name);
    let pick = |values: Vec<f64>| -> Vec<f64> {
        shown.iter().map(|&i| values.get(i).copied().unwrap_or(f64::NAN)).collect()
    };
    let stress = tensors(&grid.cell_data).map(|all| {
        let of = |&i: &usize| all.get(i).copied().unwrap_or([f64::NAN; 6]);
        let of_plane = |s: SymmetricTensor| if D > 2 { s } else { plane(s[0], s[1], s[2], s[3]) };
        shown.iter().map(of).map(of_plane).collect()
    });
    let of_cells = |name| scalars(&grid.cell_data, name).map(pick);
    let property = of_cells("material property ID");
    let frame = Frame {
        time: time(grid),
        kinetic_energy: field(grid, "kinetic energy"),
        points: grid.points.iter().map(first).collect(),
        displacement: of_points("displacement"),
        velocity: of_points("velocity"),
        force: of_points("force"),
        mass: scalars(&grid.point_data, "mass"),
        node_set: scalars(&grid.point_data, "boundary condition ID").map(integers),
        property: property.map_or_else(|| vec![0; elements.len()], integers),
        body: of_cells("body ID").map(integers),
        stress,
        damage: of_cells("damage"),
        elements,
        edge_nodes,
        joints: Vec::new(),
    };
    frame.check()?;
    Ok(frame)
}

/// The joints of a grid of joints. In the plane lines, or quads with their sides first and third;
/// in space wedges.
pub(super) fn joints<const D: usize>(grid: &UnstructuredGrid) -> Vec<Joint<D>> {
    let of_cells = |name| scalars(&grid.cell_data, name);
    let state = of_cells("joint state");
    let deleted = of_cells("deleted");
    let [set, damage, opening, sliding, mode] =
        ["joint set ID", "damage", "opening", "sliding", "failure mode"].map(of_cells);
    let moved = vectors(&grid.point_data, "displacement").unwrap_or_default();
    let at = |values: &Option<Vec<f64>>, index: usize| {
        values.as_ref().and_then(|v| v.get(index)).copied()
    };
    let place = |point: i64| {
        let x = usize::try_from(point).ok().and_then(|i| grid.points.get(i));
        x.map_or([f64::NAN; D], first)
    };
    let displaced = |point: i64| {
        let u = usize::try_from(point).ok().and_then(|i| moved.get(i));
        u.copied().unwrap_or([0.0; D])
    };
    let joint = |(index, (kind, nodes)): (usize, (Option<CellType>, &[i64]))| {
        let sides = match (kind, nodes) {
            (Some(CellType::Line), &[a, b]) => vec![[a, a], [b, b]],
            (Some(CellType::Quad), &[a, d, c, b]) => vec![[a, d], [b, c]],
            (Some(CellType::Wedge), &[a, b, c, d, e, f]) => vec![[a, d], [b, e], [c, f]],
            _ => return None,
        };
        let sides: [[i64; 2]; D] = sides.try_into().ok()?;
        let state = match (at(&state, index), at(&deleted, index)) {
            (Some(2.0), _) | (None, Some(1.0)) => JointState::Broken,
            (Some(1.0), _) => JointState::Softening,
            _ => JointState::Intact,
        };
        Some(Joint {
            ends: sides.map(|[a, b]| middle(place(a), place(b))),
            displacement: sides.map(|[a, b]| middle(displaced(a), displaced(b))),
            state,
            set: at(&set, index).map(|s| s as i32),
            damage: at(&damage, index),
            opening: at(&opening, index),
            sliding: at(&sliding, index),
            mode: at(&mode, index).filter(|&m| state == JointState::Broken && m > 0.0),
        })
    };
    cells(&grid.cells).enumerate().filter_map(joint).collect()
}

fn cells(cells: &Cells) -> impl Iterator<Item = (Option<CellType>, &[i64])> {
    let mut begin = 0;
    cells.offsets().iter().zip(cells.types()).map(move |(&end, &kind)| {
        let end = usize::try_from(end).unwrap_or(0);
        let corners = cells.connectivity().get(begin..end).unwrap_or(&[]);
        begin = end;
        (CellType::from_number(kind), corners)
    })
}

fn array<'a>(arrays: &'a [DataArray], name: &str) -> Option<&'a DataArray> {
    arrays.iter().find(|array| array.name == name)
}

fn numbers(values: &Values) -> Vec<f64> {
    match values {
        Values::Float64(v) => v.clone(),
        Values::Float32(v) => v.iter().map(|&x| f64::from(x)).collect(),
        Values::Int64(v) => v.iter().map(|&x| x as f64).collect(),
        Values::Int32(v) => v.iter().map(|&x| f64::from(x)).collect(),
        Values::UInt8(v) => v.iter().map(|&x| f64::from(x)).collect(),
    }
}

fn scalars(arrays: &[DataArray], name: &str) -> Option<Vec<f64>> {
    array(arrays, name).filter(|a| a.components.count() == 1).map(|a| numbers(&a.values))
}

fn integers(values: Vec<f64>) -> Vec<i32> {
    values.into_iter().map(|v| v as i32).collect()
}

/// The first components of a vector, as many as there are dimensions.
fn first<const D: usize>(v: &[f64; 3]) -> [f64; D] {
    std::array::from_fn(|axis| v[axis])
}

fn vectors<const D: usize>(arrays: &[DataArray], name: &str) -> Option<Vec<[f64; D]>> {
    let array = array(arrays, name).filter(|a| a.components.count() == 3)?;
    Some(numbers(&array.values).as_chunks::<3>().0.iter().map(first).collect())
}

fn tensors(arrays: &[DataArray]) -> Option<Vec<SymmetricTensor>> {
    let array = array(arrays, "Cauchy stress").filter(|a| a.components.count() == 6)?;
    Some(numbers(&array.values).as_chunks::<6>().0.to_vec())
}

fn field(grid: &UnstructuredGrid, name: &str) -> Option<f64> {
    array(&grid.field_data, name).and_then(|a| numbers(&a.values).first().copied())
}
