//! From a state of a d3plot file to a grid with its arrays.

use yformat::d3plot::{State, StateLayout};

use super::DeletedElements;
use super::cells::{Block, Element};
use crate::stress_measures::{SymmetricTensor, principal, von_mises};
use crate::vtk::{DataArray, UnstructuredGrid};

/// The grid that shows the elements of `block` in `state`.
pub(super) fn grid(
    block: &Block,
    layout: &StateLayout,
    initial: &[[f32; 3]],
    state: &State,
    deleted: DeletedElements,
) -> UnstructuredGrid {
    let mut grid = UnstructuredGrid {
        points: state.coordinates.iter().map(|x| x.map(f64::from)).collect(),
        point_data: point_data(layout, initial, state),
        field_data: vec![DataArray::time(f64::from(state.time))],
        ..UnstructuredGrid::default()
    };
    if let Some(&energy) = state.globals.first() {
        let energy = DataArray::scalar("kinetic energy", vec![f64::from(energy)]);
        grid.field_data.push(energy);
    }
    let shown: Vec<&Element> = block
        .iter()
        .filter(|e| deleted == DeletedElements::Flag || !is_deleted(e, layout, state))
        .collect();
    for element in &shown {
        grid.cells.push(element.kind, element.points());
    }
    grid.cell_data = stress_arrays(&shown, layout, state);
    let property = shown.iter().map(|e| e.material.saturating_sub(1));
    let property = DataArray::integer("material property ID", property.collect());
    grid.cell_data.push(property);
    if deleted == DeletedElements::Flag {
        let flags = shown.iter().map(|e| u8::from(is_deleted(e, layout, state)));
        let flags = DataArray::byte("deleted", flags.collect());
        grid.cell_data.push(flags);
    }
    grid
}

fn point_data(layout: &StateLayout, initial: &[[f32; 3]], state: &State) -> Vec<DataArray> {
    let displacement = state
        .coordinates
        .iter()
        .zip(initial)
        .map(|(x, x0)| std::array::from_fn(|i| f64::from(x[i]) - f64::from(x0[i])));
    let mut arrays = vec![DataArray::vector("displacement", displacement.collect())];
    let double = |vectors: &[[f32; 3]]| vectors.iter().map(|v| v.map(f64::from)).collect();
    if layout.vectors[1] {
        arrays.push(DataArray::vector("velocity", double(&state.velocities)));
    }
    if layout.vectors[2] && layout.solids > 0 {
        let forces = double(&state.accelerations);
        arrays.push(DataArray::vector("joint force", forces));
    }
    arrays
}

fn stress_arrays(shown: &[&Element], layout: &StateLayout, state: &State) -> Vec<DataArray> {
    let stresses: Vec<SymmetricTensor> =
        shown.iter().map(|element| stress(element, layout, state)).collect();
    let principal: Vec<[f64; 3]> = stresses.iter().map(principal).collect();
    let column = |i: usize| principal.iter().map(|p| p[i]).collect();
    vec![
        DataArray::scalar("von Mises stress", stresses.iter().map(von_mises).collect()),
        DataArray::scalar("Tresca stress", principal.iter().map(|p| p[0] - p[2]).collect()),
        DataArray::scalar("principal stress 1", column(0)),
        DataArray::scalar("principal stress 2", column(1)),
        DataArray::scalar("principal stress 3", column(2)),
        DataArray::symmetric_tensor("Cauchy stress", stresses),
    ]
}

/// The first six values of an element; values that the file leaves out count as 0.
fn stress(element: &Element, layout: &StateLayout, state: &State) -> SymmetricTensor {
    let (words, data) = if element.solid {
        (layout.words_per_solid, &state.solid_data)
    } else {
        (layout.words_per_shell, &state.shell_data)
    };
    let words = usize::try_from(words).unwrap_or(0);
    let start = element.index * words;
    let values = data.get(start..start + words).unwrap_or(&[]);
    std::array::from_fn(|i| values.get(i).map_or(0.0, |&v| f64::from(v)))
}

fn is_deleted(element: &Element, layout: &StateLayout, state: &State) -> bool {
    let solids = usize::try_from(layout.solids).unwrap_or(0);
    let elements = layout.solids + layout.shells;
    if layout.deletion_table != elements {
        return false;
    }
    let entry = element.index + if element.solid { 0 } else { solids };
    state.deletion_table.get(entry) == Some(&0.0)
}
