//! Turns geometry and states into the bytes of their records.

use super::error::WriteError;
use super::geometry::Geometry;
use super::layout::StateLayout;
use super::state::{NodeVectors, State, StateView, Stresses};

/// Appends the geometry section.
pub(super) fn geometry(
    buffer: &mut Vec<u8>,
    layout: &StateLayout,
    geometry: &Geometry,
) -> Result<(), WriteError> {
    expect("initial coordinates", layout.nodes, geometry.coordinates.len())?;
    expect("solids", layout.solids, geometry.solids.len())?;
    expect("shells", layout.shells, geometry.shells.len())?;
    single(buffer, geometry.coordinates.as_flattened());
    for solid in &geometry.solids {
        integers(buffer, &solid.nodes);
        integers(buffer, &[solid.material]);
    }
    for shell in &geometry.shells {
        integers(buffer, &shell.nodes);
        integers(buffer, &[shell.material]);
    }
    Ok(())
}

/// Appends one state given in double precision, rounded to single.
pub(super) fn view(
    buffer: &mut Vec<u8>,
    layout: &StateLayout,
    state: &StateView<'_>,
) -> Result<(), WriteError> {
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
    expect("deletion table", layout.deletion_table, state.deletion_table.len())?;

    put(buffer, state.time);
    if layout.globals > 0 {
        put(buffer, state.kinetic_energy);
        zeros(buffer, layout.globals - 1);
    }
    let vectors = [state.coordinates, state.velocities, state.accelerations];
    for (vectors, there) in vectors.into_iter().zip(layout.vectors) {
        if there {
            node_vectors(buffer, layout.nodes, vectors);
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
    stresses(buffer, layout.solids, layout.words_per_solid, of_solids);
    stresses(buffer, layout.shells, layout.words_per_shell, of_shells);
    for &value in state.deletion_table {
        put(buffer, value);
    }
    Ok(())
}

/// Appends one state that is in single precision already, bit for bit.
pub(super) fn recorded(
    buffer: &mut Vec<u8>,
    layout: &StateLayout,
    state: &State,
) -> Result<(), WriteError> {
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
    expect("deletion table", layout.deletion_table, state.deletion_table.len())?;

    single(buffer, &[state.time]);
    single(buffer, &state.globals);
    for (_, vectors) in vectors {
        single(buffer, vectors.as_flattened());
    }
    single(buffer, &state.solid_data);
    single(buffer, &state.shell_data);
    single(buffer, &state.deletion_table);
    Ok(())
}

fn node_vectors(buffer: &mut Vec<u8>, nodes: u64, vectors: NodeVectors<'_>) {
    match vectors {
        NodeVectors::Zero => zeros(buffer, 3 * nodes),
        NodeVectors::Plane(vectors) => {
            for &[x, y] in vectors {
                put(buffer, x);
                put(buffer, y);
                put(buffer, 0.0);
            }
        }
        NodeVectors::Spatial(vectors) => {
            for &component in vectors.as_flattened() {
                put(buffer, component);
            }
        }
    }
}

fn stresses(buffer: &mut Vec<u8>, elements: u64, words: u64, stresses: Stresses<'_>) {
    match stresses {
        Stresses::Zero => zeros(buffer, elements * words),
        Stresses::Plane(stresses) => {
            for &[xx, yy, xy] in stresses {
                element(buffer, words, [xx, yy, 0.0, xy, 0.0, 0.0]);
            }
        }
        Stresses::Spatial(stresses) => {
            for &stress in stresses {
                element(buffer, words, stress);
            }
        }
    }
}

/// One element's values: the stress, cut or filled up with zeros to `words`.
fn element(buffer: &mut Vec<u8>, words: u64, stress: [f64; 6]) {
    let mut written = 0;
    for component in stress {
        if written < words {
            put(buffer, component);
            written += 1;
        }
    }
    zeros(buffer, words - written);
}

/// One word: the double rounded to single.
#[expect(clippy::cast_possible_truncation, reason = "the format is single precision")]
fn put(buffer: &mut Vec<u8>, value: f64) {
    buffer.extend_from_slice(&(value as f32).to_le_bytes());
}

fn single(buffer: &mut Vec<u8>, values: &[f32]) {
    for value in values {
        buffer.extend_from_slice(&value.to_le_bytes());
    }
}

fn integers(buffer: &mut Vec<u8>, values: &[i32]) {
    for value in values {
        buffer.extend_from_slice(&value.to_le_bytes());
    }
}

fn zeros(buffer: &mut Vec<u8>, words: u64) {
    let bytes = usize::try_from(4 * words).unwrap_or(usize::MAX);
    buffer.resize(buffer.len().saturating_add(bytes), 0);
}

fn expect(array: &'static str, expected: u64, found: usize) -> Result<(), WriteError> {
    if expected == found as u64 {
        return Ok(());
    }
    Err(WriteError::Length { array, expected, found: found as u64 })
}
