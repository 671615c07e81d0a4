//! From grids of `.vtu` files to frames.

use ypsilon_converters::vtk::{CellType, Cells, DataArray, UnstructuredGrid, Values};

use super::frame::{Frame, Joint, JointState, minus};

/// A frame with the bodies of a grid.
pub(super) fn bodies(grid: &UnstructuredGrid) -> Result<Frame, String> {
    let mut triangles = Vec::with_capacity(grid.cells.len());
    let mut shown = Vec::with_capacity(grid.cells.len());
    for (index, (kind, corners)) in cells(&grid.cells).enumerate() {
        match (kind, corners) {
            (Some(CellType::Triangle), &[a, b, c]) => {
                triangles.push([a as u32, b as u32, c as u32]);
                shown.push(index);
            }
            (
                Some(
                    CellType::Tetra
                    | CellType::QuadraticTetra
                    | CellType::Hexahedron
                    | CellType::Wedge,
                ),
                _,
            ) => {
                return Err("the grid has solids; only plane results can be shown".to_owned());
            }
            _ => {}
        }
    }
    let of_points = |name| vectors(&grid.point_data, name);
    let pick = |values: Vec<f64>| -> Vec<f64> {
        shown.iter().map(|&i| values.get(i).copied().unwrap_or(f64::NAN)).collect()
    };
    let stress = tensors(&grid.cell_data)
        .map(|all| shown.iter().map(|&i| all.get(i).copied().unwrap_or([f64::NAN; 4])).collect());
    let of_cells = |name| scalars(&grid.cell_data, name).map(pick);
    let property = of_cells("material property ID");
    let frame = Frame {
        time: field(grid, "TimeValue").unwrap_or(0.0),
        kinetic_energy: field(grid, "kinetic energy"),
        points: grid.points.iter().map(|p| [p[0], p[1]]).collect(),
        displacement: of_points("displacement"),
        velocity: of_points("velocity"),
        force: of_points("force"),
        mass: scalars(&grid.point_data, "mass"),
        node_set: scalars(&grid.point_data, "boundary condition ID").map(integers),
        property: property.map_or_else(|| vec![0; triangles.len()], integers),
        body: of_cells("body ID").map(integers),
        stress,
        damage: of_cells("damage"),
        triangles,
        joints: Vec::new(),
    };
    frame.check()?;
    Ok(frame)
}

/// The joints of a grid of joints: lines, or quads with their sides first and third.
pub(super) fn joints(grid: &UnstructuredGrid) -> Vec<Joint> {
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
        x.map_or([f64::NAN; 2], |x| [x[0], x[1]])
    };
    let displaced = |point: i64| {
        let u = usize::try_from(point).ok().and_then(|i| moved.get(i));
        u.copied().unwrap_or([0.0; 2])
    };
    let joint = |(index, (kind, corners)): (usize, (Option<CellType>, &[i64]))| {
        let (ends, displacement) = match (kind, corners) {
            (Some(CellType::Line), &[a, b]) => ([a, b].map(place), [a, b].map(displaced)),
            (Some(CellType::Quad), &[a, d, c, b]) => (
                [mean(place(a), place(d)), mean(place(b), place(c))],
                [mean(displaced(a), displaced(d)), mean(displaced(b), displaced(c))],
            ),
            _ => return None,
        };
        let state = match (at(&state, index), at(&deleted, index)) {
            (Some(2.0), _) | (None, Some(1.0)) => JointState::Broken,
            (Some(1.0), _) => JointState::Softening,
            _ => JointState::Intact,
        };
        Some(Joint {
            ends,
            displacement,
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

pub(super) fn mean(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let half = minus(b, a).map(|d| 0.5 * d);
    [a[0] + half[0], a[1] + half[1]]
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

fn vectors(arrays: &[DataArray], name: &str) -> Option<Vec<[f64; 2]>> {
    let array = array(arrays, name).filter(|a| a.components.count() == 3)?;
    Some(numbers(&array.values).as_chunks::<3>().0.iter().map(|v| [v[0], v[1]]).collect())
}

fn tensors(arrays: &[DataArray]) -> Option<Vec<[f64; 4]>> {
    let array = array(arrays, "Cauchy stress").filter(|a| a.components.count() == 6)?;
    let tensors = numbers(&array.values);
    Some(tensors.as_chunks::<6>().0.iter().map(|s| [s[0], s[1], s[2], s[3]]).collect())
}

fn field(grid: &UnstructuredGrid, name: &str) -> Option<f64> {
    array(&grid.field_data, name).and_then(|a| numbers(&a.values).first().copied())
}
