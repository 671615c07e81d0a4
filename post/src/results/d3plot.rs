//! From states of d3plot families to frames.

use yformat::d3plot::{FamilyReader, Geometry, State};
use ypsilon_converters::stress_measures::plane;

use super::frame::{Frame, Joint, JointState};
use crate::vectors::{middle, minus};

/// State number `index` of a family, whose dimension must be that of the frame. Materials count
/// from 0 as in the deck.
pub(super) fn frame<const D: usize, const C: usize>(
    reader: &mut FamilyReader,
    index: usize,
) -> Result<Frame<D, C>, FrameError> {
    let state = reader.state(index)?;
    let (layout, geometry) = (reader.layout(), reader.geometry());
    if !layout.vectors[0] {
        return Err(FrameError::Form("the states hold no coordinates"));
    }
    let words = if D > 2 { layout.words_per_solid } else { layout.words_per_shell };
    let words = usize::try_from(words).unwrap_or(0);
    let values = if D > 2 { &state.solid_data } else { &state.shell_data };
    let in_space = |vectors: &[[f32; 3]]| -> Vec<[f64; D]> {
        vectors.iter().map(|v| std::array::from_fn(|axis| f64::from(v[axis]))).collect()
    };
    let points = in_space(&state.coordinates);
    let initial = in_space(&geometry.coordinates);
    let moved = points.iter().zip(&initial).map(|(x, x0)| minus(*x, *x0));
    let displacement: Vec<[f64; D]> = moved.collect();
    let mut frame = Frame {
        time: f64::from(state.time),
        kinetic_energy: state.globals.first().map(|&e| f64::from(e)),
        velocity: layout.vectors[1].then(|| in_space(&state.velocities)),
        ..Frame::default()
    };
    let mut stress = Vec::new();
    for (index, (shape, material)) in shapes::<D, C>(geometry).enumerate() {
        match shape {
            Some(Shape::Element(corners)) => {
                let start = index * words;
                let values = values.get(start..start + words).unwrap_or(&[]);
                let value = |i: usize| values.get(i).map_or(0.0, |&v| f64::from(v));
                frame.elements.push(corners.map(|n| (i64::from(n) - 1) as u32));
                frame.property.push(material.saturating_sub(1));
                stress.push(match D {
                    2 => plane(value(0), value(1), value(2), value(3)),
                    _ => std::array::from_fn(value),
                });
            }
            Some(Shape::Joint(sides)) => {
                let halfway = |vectors: &[[f64; D]]| {
                    let at = |n: i32| {
                        vectors.get((i64::from(n) - 1) as usize).copied().unwrap_or([f64::NAN; D])
                    };
                    sides.map(|[a, b]| middle(at(a), at(b)))
                };
                let deleted = is_deleted(&state, index);
                frame.joints.push(Joint {
                    ends: halfway(&points),
                    displacement: halfway(&displacement),
                    state: if deleted { JointState::Broken } else { JointState::Intact },
                    set: None,
                    damage: None,
                    opening: None,
                    sliding: None,
                    mode: None,
                });
            }
            None => {
                return Err(FrameError::Form(
                    "the family has solids of 8 nodes; expected tetrahedra and joints",
                ));
            }
        }
    }
    let least = if D > 2 { 6 } else { 4 };
    frame.stress = (words >= least).then_some(stress);
    frame.points = points;
    frame.displacement = Some(displacement);
    frame.check().map_err(FrameError::Damaged)?;
    Ok(frame)
}

/// What an element of a family is, by numbers of nodes from 1.
enum Shape<const D: usize, const C: usize> {
    /// Corners of a triangle or tetrahedron.
    Element([i32; C]),
    /// Pairs of nodes that lie on the two sides of a joint.
    Joint([[i32; 2]; D]),
}

/// The shells (plane) or solids (space) of a family with their materials; none for what is
/// neither body nor joint.
fn shapes<const D: usize, const C: usize>(
    geometry: &Geometry,
) -> impl Iterator<Item = (Option<Shape<D, C>>, i32)> {
    let element = |nodes: &[i32]| nodes.get(..C)?.try_into().ok().map(Shape::Element);
    let joint = |sides: &[[i32; 2]]| sides.try_into().ok().map(Shape::Joint);
    let (shells, solids) = match D {
        2 => (&geometry.shells[..], &[][..]),
        _ => (&[][..], &geometry.solids[..]),
    };
    let shells = shells.iter().map(move |shell| {
        let n = shell.nodes;
        let is_triangle = shell.is_triangle();
        (
            if is_triangle { element(&n) } else { joint(&[[n[0], n[1]], [n[3], n[2]]]) },
            shell.material,
        )
    });
    let solids = solids.iter().map(move |solid| {
        let n = solid.nodes;
        let shape = match (solid.is_tetrahedron(), solid.is_wedge()) {
            (true, _) => element(&n),
            (_, true) => joint(&[[n[0], n[3]], [n[1], n[2]], [n[4], n[6]]]),
            _ => None,
        };
        (shape, solid.material)
    });
    shells.chain(solids)
}

fn is_deleted(state: &State, element: usize) -> bool {
    state.deletion_table.get(element) == Some(&0.0)
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
