//! Output of the first step, whole files byte for byte, from the original's state after it.

use std::collections::HashMap;

use yformat::ygeo_output::{
    BrokenJoint, ElementFrame, ElementState, FractureTotals, ResultFile, TextFile,
    write_acoustic_events, write_broken_joints, write_one_dimensional_joints, write_rebars,
    write_yielded_joints,
};

use super::compare::same_but;
use super::deck::Deck;
use super::reference::{Case, cases};
use super::state::State;
use super::triangle::stress_and_strain;

/// What an output of step 0 shows, from decks and states.
struct FirstStep {
    coordinates: Vec<[f64; 2]>,
    reference_coordinates: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    forces: Vec<[f64; 2]>,
    elements: Vec<ElementState>,
    broken_joints: Vec<BrokenJoint>,
}

impl FirstStep {
    fn of(case: &Case) -> Self {
        let deck = Deck::parse(&case.read(&format!("{}.y", case.name)));
        let before = State::parse(&case.read("state_0.txt"));
        let after = State::parse(&case.read("state_1.txt"));
        let bits = |[x, y]: [f64; 2]| [x.to_bits(), y.to_bits()];
        let initial: HashMap<[u64; 2], [f64; 2]> =
            deck.table("YDN/D2NCC").into_iter().map(bits).zip(deck.table("YDN/D2NCI")).collect();

        let with_mass: Vec<usize> =
            (0..after.nodes.len()).filter(|&node| after.nodes[node].mass > 0.0).collect();
        let point: HashMap<usize, usize> =
            with_mass.iter().enumerate().map(|(point, &node)| (node, point)).collect();
        let mut triangles: Vec<_> = after.triangles.iter().collect();
        triangles.sort_by_key(|triangle| triangle.property);
        let elements = triangles.into_iter().map(|triangle| {
            let nodes = triangle.nodes.map(|node| &after.nodes[node]);
            let (stress, strain) = stress_and_strain(
                &deck,
                triangle.property,
                triangle.nodes.map(|node| initial[&bits(before.nodes[node].coordinates)]),
                nodes.map(|node| node.coordinates),
                nodes.map(|node| node.velocity),
            );
            let corners = triangle.nodes.map(|node| point[&node]);
            ElementState { corners, stress, strain, property: triangle.property as i32 }
        });
        Self {
            coordinates: with_mass.iter().map(|&node| after.nodes[node].coordinates).collect(),
            reference_coordinates: with_mass
                .iter()
                .map(|&node| before.nodes[node].coordinates)
                .collect(),
            velocities: with_mass.iter().map(|&node| after.nodes[node].velocity).collect(),
            forces: with_mass.iter().map(|&node| after.nodes[node].force).collect(),
            elements: elements.collect(),
            broken_joints: broken_joints(&after, boundary_taken_for_excavated(case)),
        }
    }

    fn elements(&self) -> ElementFrame<'_> {
        ElementFrame {
            coordinates: &self.coordinates,
            reference_coordinates: &self.reference_coordinates,
            velocities: &self.velocities,
            forces: &self.forces,
            fluid_pressures: &[],
            elements: &self.elements,
        }
    }
}

/// In these runs what Y-Geo read in front of its array (see
/// [`BrokenJoint::neighbour_excavated`]) meant "excavated".
fn boundary_taken_for_excavated(case: &Case) -> bool {
    case.name.ends_with("_jointed_mono")
}

fn broken_joints(state: &State, excavated: bool) -> Vec<BrokenJoint> {
    assert!(state.joints.iter().all(|joint| joint.property >= 0), "nothing broke in one step");
    let mut joints: Vec<_> = state.joints.iter().filter(|joint| joint.at_boundary).collect();
    joints.sort_by_key(|joint| (joint.property, joint.element));
    joints
        .into_iter()
        .map(|joint| BrokenJoint {
            corners: joint.nodes.map(|node| state.nodes[node].coordinates),
            failure_mode: 0.0,
            neighbour_excavated: excavated,
        })
        .collect()
}

fn written(write: impl FnOnce(&mut Vec<u8>) -> std::io::Result<()>) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn bytes_of(case: &Case, file: ResultFile) -> String {
    let first = FirstStep::of(case);
    written(|out| match file {
        ResultFile::Elements => {
            first.elements().write(out).unwrap();
            Ok(())
        }
        ResultFile::PrincipalDirections => {
            first.elements().write_principal_directions(out).unwrap();
            Ok(())
        }
        ResultFile::BrokenJoints => write_broken_joints(out, &first.broken_joints),
        ResultFile::YieldedJoints => write_yielded_joints(out, &[]),
        ResultFile::Rebars => write_rebars(out, &[]),
        ResultFile::OneDimensionalJoints => write_one_dimensional_joints(out, &[]),
        ResultFile::AcousticEvents => write_acoustic_events(out, &[]),
    })
}

#[test]
fn all_files_of_the_first_step_come_out_byte_for_byte() {
    let mut garbage = Vec::new();
    let mut same = 0;
    for case in cases() {
        for file in ResultFile::ALL {
            let original = case.result(file, 0);
            let ours = bytes_of(&case, file);
            if ours == original {
                same += 1;
            } else if file == ResultFile::Elements {
                assert_only_spare_room_differs(&case, &original, &ours);
                garbage.push(case.name.clone());
            } else {
                panic!("{} {file:?}: {}", case.name, first_difference(&original, &ours));
            }
        }
    }
    println!("{same} files the same; garbage where no points are in {garbage:?}");
    assert!(same > 6 * garbage.len());
}

/// In meshes with shared nodes the original's fluid pressures end in what the memory held, in
/// room that belongs to no point.
fn assert_only_spare_room_differs(case: &Case, original: &str, ours: &str) {
    let points = FirstStep::of(case).coordinates.len();
    same_but(&case.name, original, ours, &["fluid pressure"], |_, point, _, zero| {
        point >= points && zero == 0.0
    });
}

fn first_difference(original: &str, ours: &str) -> String {
    let lines = original.split('\n').zip(ours.split('\n')).enumerate();
    let Some((line, (a, b))) = lines.into_iter().find(|(_, (a, b))| a != b) else {
        return "one is longer".to_owned();
    };
    let words = a.split(' ').zip(b.split(' ')).enumerate();
    let word = words.into_iter().find(|(_, (a, b))| a != b);
    format!("line {}, word and values {word:?}", line + 1)
}

#[test]
fn the_first_line_of_totals_comes_out_byte_for_byte() {
    for case in cases() {
        let first = FirstStep::of(&case);
        let open_area = first.broken_joints.iter().map(|joint| f64::from(joint.gap().area)).sum();
        let ours = written(|out| FractureTotals { step: 0, open_area, length: 0.0 }.write(out));
        let text = case.text(&TextFile::FractureTotals.path(&case.deck())).unwrap();
        assert_eq!(text.lines().next(), Some(ours.trim_end()), "{}", case.name);
    }
}
