//! Turns geometry and states into the bytes of their records.

use super::blocks::Blocks;
use super::error::WriteError;
use super::geometry::Geometry;
use super::layout::StateLayout;
use super::state::{NodeVectors, State, StateView, Stresses};

/// Whether a geometry section has what the layout asks for.
pub(super) fn check_geometry(layout: &StateLayout, geometry: &Geometry) -> Result<(), WriteError> {
    expect("initial coordinates", layout.nodes, geometry.coordinates.len())?;
    expect("solids", layout.solids, geometry.solids.len())?;
    expect("shells", layout.shells, geometry.shells.len())
}

/// Appends the geometry section.
pub(super) fn geometry(out: &mut Blocks<'_>, geometry: &Geometry) {
    single(out, geometry.coordinates.as_flattened());
    for solid in &geometry.solids {
        integers(out, &solid.nodes);
        integers(out, &[solid.material]);
    }
    for shell in &geometry.shells {
        integers(out, &shell.nodes);
        integers(out, &[shell.material]);
    }
}

/// Whether a state has what the layout asks for.
pub(super) fn check_view(layout: &StateLayout, state: &StateView<'_>) -> Result<(), WriteError> {
    let elements = layout.solids + layout.shells;
    for (array, there, vectors) in [
        ("coordinates", layout.vectors[0], &state.coordinates),
        ("velocities", layout.vectors[1], &state.velocities),
        ("accelerations", layout.vectors[2], &state.accelerations),
    ] {
        if let (true, Some(found)) = (there, vectors.len()) {
            expect(array, layout.nodes, found)?;
        }
    }
    if let Some(found) = state.stresses.len() {
        expect("stresses", elements, found)?;
    }
    expect("deletion table", layout.deletion_table, state.deletion_table.len())
}

/// Appends one state of a computation.
pub(super) fn view(out: &mut Blocks<'_>, layout: &StateLayout, state: &StateView<'_>) {
    put(out, state.time);
    if layout.globals > 0 {
        put(out, state.kinetic_energy);
        zeros(out, layout.globals - 1);
    }
    let vectors = [state.coordinates, state.velocities, state.accelerations];
    for (vectors, there) in vectors.into_iter().zip(layout.vectors) {
        if there {
            node_vectors(out, layout.nodes, vectors);
        }
    }
    let solids = usize::try_from(layout.solids).unwrap_or(usize::MAX);
    let (of_solids, of_shells) = match state.stresses {
        Stresses::Zero => (Stresses::Zero, Stresses::Zero),
        Stresses::Plane(all) => {
            let (head, tail) = all.split_at(solids.min(all.len()));
            (Stresses::Plane(head), Stresses::Plane(tail))
        }
        Stresses::Spatial(all) => {
            let (head, tail) = all.split_at(solids.min(all.len()));
            (Stresses::Spatial(head), Stresses::Spatial(tail))
        }
    };
    stresses(out, layout.solids, layout.words_per_solid, of_solids);
    stresses(out, layout.shells, layout.words_per_shell, of_shells);
    single(out, state.deletion_table);
}

/// Whether a state that was read has what the layout asks for.
pub(super) fn check_recorded(layout: &StateLayout, state: &State) -> Result<(), WriteError> {
    expect("global values", layout.globals, state.globals.len())?;
    let vectors = [
        ("coordinates", &state.coordinates),
        ("velocities", &state.velocities),
        ("accelerations", &state.accelerations),
    ];
    for ((array, vectors), there) in vectors.iter().zip(layout.vectors) {
        expect(array, if there { layout.nodes } else { 0 }, vectors.len())?;
    }
    let of_solids = layout.solids * layout.words_per_solid;
    let of_shells = layout.shells * layout.words_per_shell;
    expect("values of the solids", of_solids, state.solid_data.len())?;
    expect("values of the shells", of_shells, state.shell_data.len())?;
    expect("deletion table", layout.deletion_table, state.deletion_table.len())
}

/// Appends one state that is in single precision already, bit for bit.
pub(super) fn recorded(out: &mut Blocks<'_>, state: &State) {
    single(out, &[state.time]);
    single(out, &state.globals);
    for vectors in [&state.coordinates, &state.velocities, &state.accelerations] {
        single(out, vectors.as_flattened());
    }
    single(out, &state.solid_data);
    single(out, &state.shell_data);
    single(out, &state.deletion_table);
}

fn node_vectors(out: &mut Blocks<'_>, nodes: u64, vectors: NodeVectors<'_>) {
    match vectors {
        NodeVectors::Zero => zeros(out, 3 * nodes),
        NodeVectors::Plane(vectors) => {
            for &[x, y] in vectors {
                single(out, &[x, y, 0.0]);
            }
        }
        NodeVectors::Spatial(vectors) => single(out, vectors.as_flattened()),
    }
}

fn stresses(out: &mut Blocks<'_>, elements: u64, words: u64, stresses: Stresses<'_>) {
    match stresses {
        Stresses::Zero => zeros(out, elements * words),
        Stresses::Plane(stresses) => {
            for &[xx, yy, xy] in stresses {
                element(out, words, [xx, yy, 0.0, xy, 0.0, 0.0]);
            }
        }
        Stresses::Spatial(stresses) => {
            for &stress in stresses {
                element(out, words, stress);
            }
        }
    }
}

/// One element's values: the stress, cut or filled up with zeros to `words`.
fn element(out: &mut Blocks<'_>, words: u64, stress: [f32; 6]) {
    let mut written = 0;
    for component in stress {
        if written < words {
            single(out, &[component]);
            written += 1;
        }
    }
    zeros(out, words - written);
}

/// One word: the double rounded to single.
#[expect(clippy::cast_possible_truncation, reason = "the format is single precision")]
fn put(out: &mut Blocks<'_>, value: f64) {
    out.put((value as f32).to_le_bytes());
}

fn single(out: &mut Blocks<'_>, values: &[f32]) {
    for value in values {
        out.put(value.to_le_bytes());
    }
}

fn integers(out: &mut Blocks<'_>, values: &[i32]) {
    for value in values {
        out.put(value.to_le_bytes());
    }
}

fn zeros(out: &mut Blocks<'_>, words: u64) {
    for _ in 0..words {
        out.put([0; 4]);
    }
}

fn expect(array: &'static str, expected: u64, found: usize) -> Result<(), WriteError> {
    if expected == found as u64 {
        return Ok(());
    }
    Err(WriteError::Length { array, expected, found: found as u64 })
}
