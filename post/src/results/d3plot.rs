//! From states of d3plot families to frames.

use yformat::d3plot::{FamilyReader, State};

use super::frame::{Frame, Joint, JointState};
use super::vtk::mean;

/// State number `index` of a family. Materials count from 0 as in the deck.
pub(super) fn frame(reader: &mut FamilyReader, index: usize) -> Result<Frame, FrameError> {
    let state = reader.state(index)?;
    let (layout, geometry) = (reader.layout(), reader.geometry());
    if !geometry.solids.is_empty() {
        return Err(FrameError::Form("the family has solids; only plane results can be shown"));
    }
    if !layout.vectors[0] {
        return Err(FrameError::Form("the states hold no coordinates"));
    }
    let words = usize::try_from(layout.words_per_shell).unwrap_or(0);
    let plane = |vectors: &[[f32; 3]]| -> Vec<[f64; 2]> {
        vectors.iter().map(|v| [f64::from(v[0]), f64::from(v[1])]).collect()
    };
    let points = plane(&state.coordinates);
    let initial = plane(&geometry.coordinates);
    let moved = points.iter().zip(&initial).map(|(x, x0)| [x[0] - x0[0], x[1] - x0[1]]);
    let displacement: Vec<[f64; 2]> = moved.collect();
    let mut frame = Frame {
        time: f64::from(state.time),
        kinetic_energy: state.globals.first().map(|&e| f64::from(e)),
        velocity: layout.vectors[1].then(|| plane(&state.velocities)),
        ..Frame::default()
    };
    let mut stress = Vec::new();
    for (index, shell) in geometry.shells.iter().enumerate() {
        let nodes = shell.nodes.map(|n| (i64::from(n) - 1) as u32);
        if shell.is_triangle() {
            let start = index * words;
            let values = state.shell_data.get(start..start + words).unwrap_or(&[]);
            let value = |i: usize| values.get(i).map_or(0.0, |&v| f64::from(v));
            frame.triangles.push([nodes[0], nodes[1], nodes[2]]);
            frame.property.push(shell.material.saturating_sub(1));
            stress.push([value(0), value(1), value(2), value(3)]);
        } else {
            let place = |i: usize| points.get(nodes[i] as usize).copied().unwrap_or([f64::NAN; 2]);
            let shift =
                |i: usize| displacement.get(nodes[i] as usize).copied().unwrap_or([f64::NAN; 2]);
            let deleted = is_deleted(&state, index);
            frame.joints.push(Joint {
                ends: [mean(place(0), place(1)), mean(place(3), place(2))],
                displacement: [mean(shift(0), shift(1)), mean(shift(3), shift(2))],
                state: if deleted { JointState::Broken } else { JointState::Intact },
                set: None,
                damage: None,
                opening: None,
                sliding: None,
                mode: None,
            });
        }
    }
    frame.stress = (words >= 4).then_some(stress);
    frame.points = points;
    frame.displacement = Some(displacement);
    frame.check().map_err(FrameError::Damaged)?;
    Ok(frame)
}

fn is_deleted(state: &State, shell: usize) -> bool {
    state.deletion_table.get(shell) == Some(&0.0)
}

/// Why a state is no frame.
pub(super) enum FrameError {
    /// The family cannot be read.
    Read(yformat::d3plot::ReadError),
    /// It is of a form that cannot be shown.
    Form(&'static str),
    /// Its parts do not fit each other.
    Damaged(String),
}

impl From<yformat::d3plot::ReadError> for FrameError {
    fn from(error: yformat::d3plot::ReadError) -> Self {
        Self::Read(error)
    }
}
