//! What the writers refuse, and values at the edges of what they take.

use yformat::ygeo_output::{
    ElementFrame, ElementFrameError, ElementState, OneDimensionalJoint, PrincipalStress,
    RebarSegment, ResultFile, TextFile, write_one_dimensional_joints, write_rebars,
};

use super::vtk_text::VtkText;

const TRIANGLE: ElementState = ElementState {
    corners: [0, 1, 2],
    stress: [[1.0, 0.0], [0.0, f64::NAN]],
    strain: [[0.0; 2]; 2],
    property: 0,
};

const POINTS: [[f64; 2]; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

fn frame(elements: &[ElementState]) -> ElementFrame<'_> {
    ElementFrame {
        coordinates: &POINTS,
        reference_coordinates: &POINTS,
        velocities: &POINTS,
        forces: &POINTS,
        fluid_pressures: &[],
        elements,
    }
}

#[test]
fn slices_that_do_not_fit_are_refused_before_anything_is_written() {
    let bad_corner = [ElementState { corners: [0, 1, 3], ..TRIANGLE }];
    let mut out = Vec::new();
    let refused = frame(&bad_corner).write(&mut out).unwrap_err();
    assert!(matches!(refused, ElementFrameError::Corner { element: 0, corner: 3, points: 3 }));
    assert!(frame(&bad_corner).write_principal_directions(&mut out).is_err());

    let short = ElementFrame { forces: &POINTS[1..], ..frame(&[TRIANGLE]) };
    let refused = short.write(&mut out).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "the frame has 3 points but 2 forces; give one for every point"
    );
    assert!(out.is_empty());
}

#[test]
fn values_that_are_no_numbers_are_printed_as_c_prints_them() {
    let mut out = Vec::new();
    frame(&[TRIANGLE]).write(&mut out).unwrap();
    let text = String::from_utf8(out).unwrap();
    assert!(text.contains("\n1.000000 0.000000 0.000000 0.000000 nan 0.000000 "));
}

#[test]
fn the_shear_stress_is_tested_as_an_integer() {
    let larger =
        |shear: f64| PrincipalStress::of([[3.0e9, shear], [shear, 1.0e9]]).larger_direction;
    assert_eq!(larger(0.999), [1.0, 0.0]);
    assert_eq!(larger(-0.999), [1.0, 0.0]);
    assert_eq!(larger(2_147_483_648.0), [1.0, 0.0]);
    assert_eq!(larger(f64::NAN), [1.0, 0.0]);
    assert_ne!(larger(2_147_483_647.0), [1.0, 0.0]);
    assert_ne!(larger(-2_147_483_647.0), [1.0, 0.0]);
    assert_eq!(PrincipalStress::of([[0.0; 2]; 2]).maximum(), 0.0);
}

#[test]
fn principal_stresses_are_sorted_by_sign() {
    let stress = PrincipalStress::of([[-3.0, 0.0], [0.0, 1.0]]);
    assert_eq!((stress.larger, stress.smaller), (-3.0, 1.0));
    assert_eq!((stress.minimum(), stress.maximum()), (-3.0, 1.0));
    let stress = PrincipalStress::of([[5.0, 0.0], [0.0, 1.0]]);
    assert_eq!((stress.minimum(), stress.maximum()), (1.0, 5.0));
}

#[test]
fn rebars_and_their_joints_become_flat_quadrilaterals() {
    let segment = RebarSegment {
        ends: [[0.0, 0.5], [1.0, 0.5]],
        area: 2.0,
        stress: 10.0,
        force: 20.0,
        strain: 0.125,
        activation_flag: 1,
    };
    let mut out = Vec::new();
    write_rebars(&mut out, &[segment; 2]).unwrap();
    let file = VtkText::parse(&String::from_utf8(out).unwrap());
    let [left, right] = segment.ends;
    assert_eq!(file.plane_vectors("Points"), [left, left, right, right].repeat(2));
    assert_eq!(file.get("connectivity"), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);
    assert_eq!(file.get("offsets"), [4.0, 8.0]);
    assert_eq!(file.get("rebar_force"), [20.0; 2]);
    assert_eq!(file.get("rebar_activation_flag"), [1.0; 2]);

    let joint = OneDimensionalJoint {
        ends: segment.ends,
        axial_stress: 1.0,
        shear_stress: 2.0,
        axial_displacement: 0.25,
        shear_displacement: 0.5,
        state: 4,
    };
    let mut out = Vec::new();
    write_one_dimensional_joints(&mut out, &[joint]).unwrap();
    let file = VtkText::parse(&String::from_utf8(out).unwrap());
    assert_eq!(file.plane_vectors("Points"), [left, left, right, right]);
    assert_eq!(file.get("1D_joint_shear_displacement"), [0.5]);
    assert_eq!(file.get("1D_joint_state"), [4.0]);
}

#[test]
fn names_stand_behind_the_whole_name_of_the_deck() {
    let deck = std::path::Path::new("runs.1/wall.y");
    let name = |file: ResultFile| file.path(deck, 200).to_str().unwrap().to_owned();
    assert_eq!(name(ResultFile::Elements), "runs.1/wall.y_200.vtp");
    assert_eq!(name(ResultFile::AcousticEvents), "runs.1/wall.y_acoustic_200.vtu");
    assert_eq!(TextFile::Hydrofracture.path(deck).to_str(), Some("runs.1/wall.yhHF"));
    assert_eq!(TextFile::Restart(2).path(deck).to_str(), Some("runs.1/wall.yres2"));
}
