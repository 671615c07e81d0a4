//! Files parsed and written again: what is stored comes back byte for byte, what the writers
//! derive from it comes close to what the original derived from more digits.

use yformat::ygeo_output::{
    AcousticEvent, BrokenJoint, ElementFrame, ElementState, FractureTotals, JointGap,
    PrincipalStress, ResultFile, TextFile, YieldMode, YieldedJoint, write_acoustic_events,
    write_broken_joints, write_one_dimensional_joints, write_rebars, write_yielded_joints,
};

use super::compare::{Agreement, same_but};
use super::reference::{Case, cases, committed};
use super::vtk_text::VtkText;

/// Half a unit of the last digit printed, and a little.
const PRINTED: f64 = 0.51e-6;

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

fn every_output(mut check: impl FnMut(&Case, u64)) {
    for case in cases().into_iter().chain(committed()) {
        for step in case.steps() {
            check(&case, step);
        }
    }
}

/// Points and elements as the frames of a step have them.
struct Frame {
    coordinates: Vec<[f64; 2]>,
    reference: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    forces: Vec<[f64; 2]>,
    pressures: Vec<f64>,
    elements: Vec<ElementState>,
}

impl Frame {
    fn parse(original: &str) -> Self {
        let file = VtkText::parse(original);
        let coordinates = file.plane_vectors("Points");
        let displacements = file.plane_vectors("displacement");
        // A displacement printed as -0.000000 hides a small negative number.
        let minus =
            |x: f64, u: f64| if u == 0.0 && u.is_sign_negative() { x + 1e-9 } else { x - u };
        let minus = |[x, y]: [f64; 2], [u, v]: [f64; 2]| [minus(x, u), minus(y, v)];
        let reference = coordinates.iter().zip(displacements).map(|(&x, u)| minus(x, u));
        let stresses = file.tensors("stress").into_iter().zip(file.tensors("strain"));
        let elements = stresses
            .zip(file.get("property_id"))
            .zip(file.get("connectivity").chunks_exact(3))
            .map(|(((stress, strain), &property), corners)| ElementState {
                corners: [corners[0] as usize, corners[1] as usize, corners[2] as usize],
                stress: stress.map(|row| row.map(|value| f64::from(value as f32))),
                strain,
                property: property as i32,
            });
        Self {
            reference: reference.collect(),
            velocities: file.plane_vectors("velocity"),
            forces: file.plane_vectors("force"),
            pressures: file.get("fluid pressure").to_vec(),
            elements: elements.collect(),
            coordinates,
        }
    }

    fn view(&self) -> ElementFrame<'_> {
        ElementFrame {
            coordinates: &self.coordinates,
            reference_coordinates: &self.reference,
            velocities: &self.velocities,
            forces: &self.forces,
            fluid_pressures: &self.pressures,
            elements: &self.elements,
        }
    }
}

/// What single precision takes from the largest component: the original had the stress to double
/// precision when it took the principal stresses. Where the trace is tiny, so is what keeps its
/// own division from zero, 1e-10, and the printed trace does not tell their ratio.
fn rounding(stress: [[f64; 2]; 2]) -> f64 {
    let largest = stress.as_flattened().iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let trace = (stress[0][0] + stress[1][1]).abs();
    (2.0 * f64::from(f32::EPSILON) + 1e-10 / trace.max(1e-10)) * largest
}

#[test]
fn stored_values_of_elements_come_back_and_principal_stresses_follow() {
    let mut principal = Agreement::default();
    every_output(|case, step| {
        let original = case.result(ResultFile::Elements, step);
        let frame = Frame::parse(&original);
        let mut ours = Vec::new();
        frame.view().write(&mut ours).unwrap();
        let what = format!("{} step {step}", case.name);
        let loose = ["principal_stress"];
        let agreement = same_but(&what, &original, &text(ours), &loose, |_, index, a, b| {
            (a - b).abs() <= rounding(frame.elements[index / 9].stress) + 2.0 * PRINTED
        });
        principal.add(agreement);
    });
    println!("principal stresses from printed stresses, zeros included: {principal:?}");
    assert!(principal.same * 10 > principal.all * 9, "{principal:?}");
}

#[test]
fn principal_directions_follow_from_the_printed_stresses() {
    let mut directions = Agreement::default();
    let mut fallbacks = 0;
    every_output(|case, step| {
        let frame = Frame::parse(&case.result(ResultFile::Elements, step));
        let original = case.result(ResultFile::PrincipalDirections, step);
        let mut ours = Vec::new();
        frame.view().write_principal_directions(&mut ours).unwrap();
        let what = format!("{} step {step}", case.name);
        let loose = ["principal_stress_direction_1", "principal_stress_direction_2", "Points"];
        let agreement = same_but(&what, &original, &text(ours), &loose, |array, index, a, b| {
            let [[xx, xy], [_, yy]] = frame.elements[index / 3].stress;
            let principal = PrincipalStress::of(frame.elements[index / 3].stress);
            let length = match array {
                "principal_stress_direction_1" => xy.hypot(f64::from(principal.larger) - xx),
                "principal_stress_direction_2" => xy.hypot(f64::from(principal.smaller) - yy),
                _ => return (a - b).abs() <= 3.0 * PRINTED + f64::from(f32::EPSILON) * a.abs(),
            };
            let angle = rounding(frame.elements[index / 3].stress) / length;
            (a - b).abs() <= angle + 2.0 * PRINTED
        });
        directions.add(agreement);
        let flat = |element: &&ElementState| {
            PrincipalStress::of(element.stress).larger_direction == [1.0, 0.0]
        };
        fallbacks += frame.elements.iter().filter(flat).count();
    });
    println!("directions and centroids: {directions:?}; {fallbacks} without direction");
    assert!(directions.same * 10 > directions.all * 9, "{directions:?}");
    assert!(fallbacks > 0, "the test of the shear stress is exercised");
}

/// Corners of joints from the points of their two flat quadrilaterals.
fn corners(points: &[[f64; 2]]) -> Vec<[[f64; 2]; 4]> {
    points.chunks_exact(8).map(|p| [p[0], p[2], p[4], p[6]]).collect()
}

fn is_closed([a, b, c, d]: [[f64; 2]; 4]) -> bool {
    a == d && b == c
}

#[test]
fn gaps_of_broken_joints_follow_from_the_printed_coordinates() {
    let mut gaps = Agreement::default();
    let mut open = 0;
    every_output(|case, step| {
        let original = case.result(ResultFile::BrokenJoints, step);
        let file = VtkText::parse(&original);
        let modes = file.get("broken_mode_of_failure");
        let joints: Vec<BrokenJoint> = corners(&file.plane_vectors("Points"))
            .into_iter()
            .zip(modes.chunks_exact(2))
            .map(|(corners, mode)| BrokenJoint {
                corners,
                failure_mode: mode[0],
                neighbour_excavated: false,
            })
            .collect();
        open += joints.iter().filter(|joint| !is_closed(joint.corners)).count();
        let mut ours = Vec::new();
        write_broken_joints(&mut ours, &joints).unwrap();
        let what = format!("{} step {step}", case.name);
        let loose = ["broken_sliding", "broken_opening", "broken_area"];
        let agreement = same_but(&what, &original, &text(ours), &loose, |array, index, a, b| {
            // Two corners, each moved by what printing hid, in both directions.
            let hidden = 4.0 * PRINTED;
            let gap = JointGap::between(joints[index / 2].corners);
            let [[x0, y0], [x1, y1], ..] = joints[index / 2].corners;
            let length = (x1 - x0).hypot(y1 - y0) + f64::from(gap.opening + gap.sliding);
            (a - b).abs() <= if array == "broken_area" { hidden * length } else { hidden }
        });
        gaps.add(agreement);

        let totals = case.text(&TextFile::FractureTotals.path(&case.deck())).unwrap();
        let line = totals.lines().find(|line| line.starts_with(&format!("{step}\t"))).unwrap();
        let total: f64 = line.split('\t').nth(1).unwrap().parse().unwrap();
        let sum: f64 = file.get("broken_area").chunks_exact(2).map(|pair| pair[0]).sum();
        assert!((sum - total).abs() <= 0.51e-9 * (joints.len() + 1) as f64, "{what}");
    });
    println!("gaps: {gaps:?}, {open} open joints");
    assert!(open > 0);
}

#[test]
fn yielded_joints_come_back_byte_for_byte() {
    let mut seen = [0; 3];
    every_output(|case, step| {
        let original = case.result(ResultFile::YieldedJoints, step);
        let file = VtkText::parse(&original);
        let modes = file.get("yielded_mode_of_failure").chunks_exact(2);
        let joints: Vec<YieldedJoint> = corners(&file.plane_vectors("Points"))
            .into_iter()
            .zip(modes)
            .map(|(corners, mode)| {
                let code = mode[0] as i64;
                seen[code as usize - 1] += 1;
                let flag = [2, 3, 1][code as usize - 1];
                YieldedJoint { corners, mode: YieldMode::from_flag(flag).unwrap() }
            })
            .collect();
        let mut ours = Vec::new();
        write_yielded_joints(&mut ours, &joints).unwrap();
        same_but(&format!("{} {step}", case.name), &original, &text(ours), &[], |_, _, _, _| false);
    });
    println!("opened, slid, both: {seen:?}");
    assert!(seen[0] > 0);
    assert_eq!(YieldMode::from_flag(0), None);
}

#[test]
fn acoustic_events_come_back_and_their_magnitudes_follow() {
    let mut magnitudes = Agreement::default();
    every_output(|case, step| {
        let original = case.result(ResultFile::AcousticEvents, step);
        let file = VtkText::parse(&original);
        let numbers = |name| file.get(name).iter().copied();
        let events: Vec<AcousticEvent> = file
            .plane_vectors("Points")
            .into_iter()
            .zip(numbers("acoustic_energy"))
            .zip(numbers("acoustic_fracture_energy").zip(numbers("acoustic_event_mode")))
            .map(|((position, energy), (fracture_energy, failure_mode))| AcousticEvent {
                position,
                energy,
                fracture_energy,
                failure_mode,
            })
            .collect();
        let mut ours = Vec::new();
        write_acoustic_events(&mut ours, &events).unwrap();
        let what = format!("{} step {step}", case.name);
        let loose = ["acoustic_magnitude"];
        let agreement = same_but(&what, &original, &text(ours), &loose, |_, index, a, b| {
            let hidden = PRINTED / events[index].energy / 1.5 / std::f64::consts::LN_10;
            (a - b).abs() <= hidden + 2.0 * PRINTED
        });
        magnitudes.add(agreement);
    });
    println!("magnitudes: {magnitudes:?}");
    assert!(magnitudes.same * 2 > magnitudes.all && magnitudes.all > 0);
}

#[test]
fn frames_of_rebars_come_back_byte_for_byte() {
    every_output(|case, step| {
        let mut ours = Vec::new();
        write_rebars(&mut ours, &[]).unwrap();
        assert_eq!(text(ours), case.result(ResultFile::Rebars, step), "{} {step}", case.name);
        let mut ours = Vec::new();
        write_one_dimensional_joints(&mut ours, &[]).unwrap();
        let original = case.result(ResultFile::OneDimensionalJoints, step);
        assert_eq!(text(ours), original, "{} {step}", case.name);
    });
}

#[test]
fn totals_come_back_byte_for_byte() {
    for case in cases().into_iter().chain(committed()) {
        let original = case.text(&TextFile::FractureTotals.path(&case.deck())).unwrap();
        let mut ours = Vec::new();
        for line in original.lines() {
            let words: Vec<&str> = line.split('\t').collect();
            let totals = FractureTotals {
                step: words[0].parse().unwrap(),
                open_area: words[1].parse().unwrap(),
                length: words[2].parse().unwrap(),
            };
            totals.write(&mut ours).unwrap();
        }
        assert_eq!(text(ours), original, "{}", case.name);
    }
}
