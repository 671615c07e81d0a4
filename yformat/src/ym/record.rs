//! Records in SI units, and how they become reals of -1 to 1.

use super::Scales;

/// Fixed scale of acoustic magnitudes.
const MAGNITUDE_SCALE: f64 = 15.0;
/// Fixed scale of failure modes.
const MODE_SCALE: f64 = 2.0;

/// One line of a snapshot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Record {
    /// A triangle.
    Triangle(Triangle),
    /// A broken or pre-existing joint.
    FractureJoint(FractureJoint),
    /// An edge of the model's boundary.
    BoundaryJoint(BoundaryJoint),
    /// Where a joint broke.
    AcousticSource(AcousticSource),
}

/// The mean velocity of a triangle.
///
/// The original divides the sum by three and by the scale at once; to code the same digit the
/// sum is kept.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeanVelocity {
    sum: [f64; 2],
    corners: f64,
}

impl MeanVelocity {
    /// The mean of three corners, m/s.
    #[must_use]
    pub fn of_corners(velocities: [[f64; 2]; 3]) -> Self {
        let [a, b, c] = velocities;
        Self { sum: [a[0] + b[0] + c[0], a[1] + b[1] + c[1]], corners: 3.0 }
    }

    /// A mean that is known, m/s.
    #[must_use]
    pub fn new(mean: [f64; 2]) -> Self {
        Self { sum: mean, corners: 1.0 }
    }

    /// The mean, m/s.
    #[must_use]
    pub fn get(&self) -> [f64; 2] {
        self.sum.map(|sum| sum / self.corners)
    }
}

/// A triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Triangle {
    /// Its corners, m.
    pub corners: [[f64; 2]; 3],
    /// Mean velocity of the corners.
    pub velocity: MeanVelocity,
    /// Stress xx, yy, xy, Pa, tension positive.
    pub stress: [f64; 3],
    /// 0 intact, 1 broken; 0 for elastic and rigid triangles.
    pub damage: f64,
    /// Contact force at the boundary, N; only elastic triangles have the field.
    pub contact_force: Option<[f64; 2]>,
}

/// A joint that is a fracture: pre-existing or broken.
///
/// Nodes 0 and 1 lie on one wall, 2 and 3 on the other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FractureJoint {
    /// Its nodes, m.
    pub nodes: [[f64; 2]; 4],
    /// 0 pre-existing, 1 tension, 2 shear, between mixed. Larger values are cut to 2.
    pub failure_mode: f64,
    /// Normal stress, Pa, compression positive.
    pub normal_stress: f64,
    /// Shear stress, Pa.
    pub shear_stress: f64,
    /// Mean of the magnitudes of the sliding forces of the two triangles, N: half their sum.
    pub sliding_force: f64,
    /// Mechanical aperture, m. A closed joint (0) comes back as the scale.
    pub aperture: f64,
    /// Magnitude of the shear displacement, m.
    pub shear_displacement: f64,
    /// Dilation, m.
    pub dilation: f64,
    /// Hydraulic aperture, m. 0 comes back as the scale.
    pub hydraulic_aperture: f64,
}

/// An edge of the model's boundary, which the program keeps as a joint without other side.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryJoint {
    /// Its nodes, m: the edge runs from node 0 to node 1.
    pub nodes: [[f64; 2]; 4],
    /// Contact force of the triangle that it belongs to, N.
    pub contact_force: [f64; 2],
}

/// Where a joint broke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AcousticSource {
    /// Centre of the joint, m.
    pub position: [f64; 2],
    /// Magnitude of the event; -15 if there was none.
    pub magnitude: f64,
}

/// The reals of a record in the order of the file, in units of their scales.
pub(super) struct Units {
    values: [f64; 16],
    length: usize,
}

impl Units {
    fn new() -> Self {
        Self { values: [0.0; 16], length: 0 }
    }

    /// Adds a real; more than the longest record has are not added.
    fn push(&mut self, unit: f64) {
        if let Some(slot) = self.values.get_mut(self.length) {
            *slot = unit;
            self.length += 1;
        }
    }

    /// Adds all x, then all y.
    fn push_points(&mut self, points: &[[f64; 2]], scale: f64) {
        points.iter().for_each(|&[x, _]| self.push(x / scale));
        points.iter().for_each(|&[_, y]| self.push(y / scale));
    }

    pub(super) fn as_slice(&self) -> &[f64] {
        self.values.get(..self.length).unwrap_or_default()
    }
}

impl Record {
    /// The reals of the line, each divided as the original divides it. (outputs.md 1.3)
    pub(super) fn to_units(self, scales: &Scales) -> Units {
        let mut units = Units::new();
        match self {
            Record::Triangle(triangle) => {
                units.push_points(&triangle.corners, scales.coordinate);
                let MeanVelocity { sum, corners } = triangle.velocity;
                sum.iter().for_each(|sum| units.push(sum / (corners * scales.velocity)));
                triangle.stress.iter().for_each(|stress| units.push(stress / scales.stress));
                units.push(triangle.damage);
                let force = triangle.contact_force.iter().flatten();
                force.for_each(|force| units.push(force / scales.force));
            }
            Record::FractureJoint(joint) => {
                units.push_points(&joint.nodes, scales.coordinate);
                units.push(joint.failure_mode / MODE_SCALE);
                units.push(joint.normal_stress / scales.stress);
                units.push(joint.shear_stress / scales.stress);
                units.push(joint.sliding_force / scales.force);
                units.push(scales.aperture_to_unit(joint.aperture));
                units.push(joint.shear_displacement / scales.displacement);
                units.push(joint.dilation / scales.displacement);
                units.push(scales.aperture_to_unit(joint.hydraulic_aperture));
            }
            Record::BoundaryJoint(joint) => {
                units.push_points(&joint.nodes, scales.coordinate);
                joint.contact_force.iter().for_each(|force| units.push(force / scales.force));
                (0..6).for_each(|_| units.push(0.0));
            }
            Record::AcousticSource(source) => {
                units.push_points(&[source.position], scales.coordinate);
                units.push(source.magnitude / MAGNITUDE_SCALE);
                (0..4).for_each(|_| units.push(0.0));
            }
        }
        units
    }

    /// The reverse for a triangle of 12 reals and, with contact force, 14.
    pub(super) fn triangle(units: &[f64], scales: &Scales) -> Self {
        let at = |index: usize| units.get(index).copied().unwrap_or(0.0);
        Record::Triangle(Triangle {
            corners: std::array::from_fn(|k| [at(k), at(3 + k)].map(|u| u * scales.coordinate)),
            velocity: MeanVelocity::new([at(6), at(7)].map(|u| u * scales.velocity)),
            stress: [at(8), at(9), at(10)].map(|u| u * scales.stress),
            damage: at(11),
            contact_force: (units.len() > 12).then(|| [at(12), at(13)].map(|u| u * scales.force)),
        })
    }

    /// The reverse for a fracture.
    pub(super) fn fracture_joint(units: &[f64; 16], scales: &Scales) -> Self {
        let [.., mode, normal, shear, force, aperture, displacement, dilation, hydraulic] = *units;
        Record::FractureJoint(FractureJoint {
            nodes: four_nodes(units, scales),
            failure_mode: mode * MODE_SCALE,
            normal_stress: normal * scales.stress,
            shear_stress: shear * scales.stress,
            sliding_force: force * scales.force,
            aperture: scales.aperture_from_unit(aperture),
            shear_displacement: displacement * scales.displacement,
            dilation: dilation * scales.displacement,
            hydraulic_aperture: scales.aperture_from_unit(hydraulic),
        })
    }

    /// The reverse for a boundary.
    pub(super) fn boundary_joint(units: &[f64; 16], scales: &Scales) -> Self {
        Record::BoundaryJoint(BoundaryJoint {
            nodes: four_nodes(units, scales),
            contact_force: [units[8], units[9]].map(|u| u * scales.force),
        })
    }

    /// The reverse for an acoustic source.
    pub(super) fn acoustic_source(units: &[f64; 16], scales: &Scales) -> Self {
        Record::AcousticSource(AcousticSource {
            position: [units[0], units[1]].map(|u| u * scales.coordinate),
            magnitude: units[2] * MAGNITUDE_SCALE,
        })
    }
}

/// Four nodes: all x, then all y.
fn four_nodes(units: &[f64; 16], scales: &Scales) -> [[f64; 2]; 4] {
    std::array::from_fn(|k| [units[k], units[4 + k]].map(|u| u * scales.coordinate))
}
