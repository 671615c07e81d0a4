//! Pairs of triangles and of tetrahedra that lie in each other, or against each other, as no sound
//! scene has them.

use super::motion::{Motion, conserved, evaluate, step};
use crate::support::stability_scenes::Body;
use ypsilon::scene::{PressedFaces, SpatialContact};

const PENALTY: f64 = 1e5;
/// So little that what a full overlap holds does not crush the elements.
const SOFT: f64 = 1e2;
/// Smallest shifts that matter to rounding, to the tolerance of the method, and beyond.
const SHIFTS: [f64; 7] = [0.0, 1e-16, -1e-16, 1e-12, -1e-12, 1e-8, -1e-8];

type Triangle = [[f64; 2]; 3];
type Tetrahedron = [[f64; 3]; 4];

const UNIT: Triangle = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];

/// What lies with the unit triangle.
const TRIANGLES: [(&str, Triangle); 14] = [
    ("identical", UNIT),
    ("vertex on vertex", [[0.0, 0.0], [-1.0, 0.0], [0.0, -1.0]]),
    ("vertex on edge", [[0.5, 0.0], [0.0, -1.0], [1.0, -1.0]]),
    ("edge on edge", [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]),
    ("edge on a part of an edge", [[0.25, 0.0], [0.5, -1.0], [0.75, 0.0]]),
    ("edges that share a part", [[0.5, 0.0], [1.0, -1.0], [1.5, 0.0]]),
    ("edge on edge from within", [[0.2, 0.0], [0.8, 0.0], [0.3, 0.3]]),
    ("contained", [[0.2, 0.2], [0.4, 0.2], [0.2, 0.4]]),
    ("contained around the centroid", [[0.3, 0.3], [0.4, 0.3], [0.3, 0.4]]),
    ("containing", [[-1.0, -1.0], [3.0, -1.0], [-1.0, 3.0]]),
    (
        "turned by half a turn",
        [[2.0 / 3.0, 2.0 / 3.0], [-1.0 / 3.0, 2.0 / 3.0], [2.0 / 3.0, -1.0 / 3.0]],
    ),
    ("vertex on the centroid", [[1.0 / 3.0, 1.0 / 3.0], [-1.0, 0.5], [-1.0, 0.0]]),
    ("needle across", [[-1.0, 0.3], [2.0, 0.3], [2.0, 0.300_001]]),
    ("shared vertex and crossing", [[0.0, 0.0], [0.9, 0.1], [0.1, 0.9]]),
];

/// Two triangles on their own.
fn pair(a: &Triangle, b: &Triangle, penalty: f64) -> Body {
    let mut body = Body { penalty, ..Body::new(2) };
    body.coordinates = a.iter().chain(b).flatten().copied().collect();
    body.sets = vec![0; 6];
    body.elements = (0..6).collect();
    body
}

#[test]
fn triangles_exert_equal_and_opposite_forces() {
    let mut worst: f64 = 0.0;
    for (name, other) in TRIANGLES {
        for dx in SHIFTS {
            for dy in SHIFTS {
                let shifted = other.map(|[x, y]| [x + dx, y + dy]);
                for [a, b] in [[UNIT, shifted], [shifted, UNIT]] {
                    let mut moving = pair(&a, &b, PENALTY).simulation();
                    evaluate(&mut moving);
                    let motion = Motion::of(&moving);
                    assert!(motion.is_finite(), "{name} {dx} {dy}");
                    let [sum, moment] = motion.imbalance();
                    let size: f64 = motion.forces.iter().map(|f| f.norm()).sum();
                    // no potential is above the penalty, no edge inside longer than the triangle
                    assert!(size <= 60.0 * PENALTY, "{name} {dx} {dy}: {size:e}");
                    // beside forces that are themselves rounding nothing is left to be opposite
                    if size > 1e-6 * PENALTY {
                        worst = worst.max(sum).max(moment);
                    }
                }
            }
        }
    }
    assert!(worst < 1e-14, "{worst:e} of the forces is left over");
}

#[test]
fn triangles_part_with_the_energy_that_their_overlap_held() {
    for (name, other) in TRIANGLES {
        let mut moving = pair(&UNIT, &other, SOFT).simulation();
        let limits = moving.limits();
        let dt = 0.05 * limits.impact_s.min(limits.critical_s);
        let found = conserved(&mut moving, dt, 4_000);
        // edges are cut anew as they cross corners and centroids: kinks, passed over by steps
        assert!(found.worst < 0.01, "{name}: {found:?}");
        // at rest where nothing overlaps, or where by symmetry nothing says whereto
        let rests = found.last.kinetic <= 1e-15 * found.first.contact_stored;
        let is_balanced = ["identical", "turned by half a turn"].contains(&name);
        assert_eq!(rests, is_balanced || found.first.contact_stored == 0.0, "{name}: {found:?}");
        if !rests {
            assert!(found.momentum < 1e-13 && found.angular < 1e-12, "{name}: {found:?}");
        }
    }
}

const CORNER: Tetrahedron = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// What lies with the tetrahedron in the corner.
const TETRAHEDRA: [(&str, Tetrahedron); 12] = [
    ("identical", CORNER),
    ("vertex on vertex", [[0.0; 3], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]]),
    ("vertex on edge", [[0.5, 0.0, 0.0], [0.0, -1.0, -1.0], [0.5, -1.0, -2.0], [1.0, -1.0, -1.0]]),
    ("vertex on face", [[0.25, 0.25, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, -1.0], [1.0, 0.0, -1.0]]),
    ("edge across edge", [[0.5, -0.5, 0.0], [0.5, 0.5, 0.0], [0.5, 0.0, -1.0], [1.0, 0.0, -1.0]]),
    ("face on face", [[0.0; 3], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
    (
        "face on a part of a face",
        [[0.1, 0.1, 0.0], [0.1, 0.5, 0.0], [0.5, 0.1, 0.0], [0.1, 0.1, -1.0]],
    ),
    ("contained", [[0.1, 0.1, 0.1], [0.3, 0.1, 0.1], [0.1, 0.3, 0.1], [0.1, 0.1, 0.3]]),
    (
        "contained, face in face",
        [[0.1, 0.1, 0.0], [0.3, 0.1, 0.0], [0.1, 0.3, 0.0], [0.1, 0.1, 0.2]],
    ),
    ("containing", [[-1.0, -1.0, -1.0], [4.0, -1.0, -1.0], [-1.0, 4.0, -1.0], [-1.0, -1.0, 4.0]]),
    ("point reflection", [[0.5, 0.5, 0.5], [-0.5, 0.5, 0.5], [0.5, 0.5, -0.5], [0.5, -0.5, 0.5]]),
    (
        "vertex on the centroid",
        [[0.25, 0.25, 0.25], [-1.0, 0.0, 0.0], [-1.0, 0.5, 0.0], [-1.0, 0.0, 0.5]],
    ),
];

/// Two tetrahedra on their own, all with positive volume.
fn solid_pair(a: &Tetrahedron, b: &Tetrahedron, pressed: PressedFaces, penalty: f64) -> Body {
    let spatial_contact = SpatialContact { pressed, has_friction: false };
    let mut body = Body { penalty, spatial_contact, ..Body::new(3) };
    body.coordinates = a.iter().chain(b).flatten().copied().collect();
    body.sets = vec![0; 8];
    body.elements = (0..8).collect();
    for (index, corners) in [a, b].into_iter().enumerate() {
        if volume(corners) < 0.0 {
            body.elements.swap(4 * index + 2, 4 * index + 3);
        }
    }
    body
}

/// Volume of a tetrahedron.
fn volume(corners: &Tetrahedron) -> f64 {
    let [a, b, c, d] = corners.map(nalgebra::Vector3::from);
    (b - a).cross(&(c - a)).dot(&(d - a)) / 6.0
}

#[test]
fn tetrahedra_exert_equal_and_opposite_forces() {
    for pressed in [PressedFaces::Contactor, PressedFaces::Both] {
        let mut worst: f64 = 0.0;
        for (name, other) in TETRAHEDRA {
            for dx in SHIFTS {
                for dz in SHIFTS {
                    let shifted = other.map(|[x, y, z]| [x + dx, y, z + dz]);
                    for [a, b] in [[CORNER, shifted], [shifted, CORNER]] {
                        let mut moving = solid_pair(&a, &b, pressed, PENALTY).simulation();
                        evaluate(&mut moving);
                        let motion = Motion::of(&moving);
                        assert!(motion.is_finite(), "{name} {dx} {dz} {pressed:?}");
                        let [sum, moment] = motion.imbalance();
                        let size: f64 = motion.forces.iter().map(|f| f.norm()).sum();
                        assert!(size <= 300.0 * PENALTY, "{name} {dx} {dz}: {size:e}");
                        if size > 1e-6 * PENALTY {
                            worst = worst.max(sum).max(moment);
                        }
                    }
                }
            }
        }
        assert!(worst < 1e-14, "{pressed:?}: {worst:e} of the forces and moments is left over");
    }
}

/// 6 p (∫P dV of both) is what two-sided contact holds, and ∫P is at most a quarter of a volume.
#[test]
fn tetrahedra_part_with_no_more_energy_than_their_overlap_held() {
    for pressed in [PressedFaces::Contactor, PressedFaces::Both] {
        for (name, other) in TETRAHEDRA {
            let mut moving = solid_pair(&CORNER, &other, pressed, SOFT).simulation();
            let limits = moving.limits();
            let dt = 0.05 * limits.impact_s.min(limits.critical_s);
            moving.run(dt, 0);
            let most = 6.0 * SOFT * (volume(&CORNER) + volume(&other).abs()) / 4.0;
            let mut kinetic: f64 = 0.0;
            for _ in 0..4_000 {
                step(&mut moving);
                kinetic = kinetic.max(Motion::of(&moving).kinetic_energy());
            }
            let motion = Motion::of(&moving);
            assert!(motion.is_finite(), "{name}");
            let momentum = motion.momentum().norm();
            assert!(momentum <= 1e-12 * motion.impetus(), "{pressed:?} {name}: {momentum:e}");
            // the original's law has no potential
            if pressed == PressedFaces::Both {
                assert!(kinetic <= most, "{name}: {kinetic:e} of {most:e}");
            }
        }
    }
}
