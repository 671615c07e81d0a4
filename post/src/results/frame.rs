//! The state at one time.

use ypsilon_converters::stress_measures::{SymmetricTensor, plane};

use crate::error::PostError;

/// How a joint is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum JointState {
    /// Below its strength.
    Intact,
    /// Softening somewhere.
    Softening,
    /// Carries nothing any more.
    Broken,
}

/// A joint, as a line along its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// Its two ends where they are now, m.
    pub ends: [[f64; 2]; 2],
    /// What the ends have moved, m.
    pub displacement: [[f64; 2]; 2],
    /// How it is doing.
    pub state: JointState,
    /// Joint set, where known.
    pub set: Option<i32>,
    /// Damage in [0, 1], where known.
    pub damage: Option<f64>,
    /// Opening in the middle, m, where known.
    pub opening: Option<f64>,
    /// Sliding in the middle, m, where known.
    pub sliding: Option<f64>,
    /// How it failed: 1 in tension, 2 in shear, between them in both; where known.
    pub mode: Option<f64>,
}

/// Bodies and joints at one time. Parts that the files leave out are `None`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Frame {
    /// Time, s.
    pub time: f64,
    /// Kinetic energy that the file tells, J.
    pub kinetic_energy: Option<f64>,
    /// Current coordinates, m.
    pub points: Vec<[f64; 2]>,
    /// Displacements, m.
    pub displacement: Option<Vec<[f64; 2]>>,
    /// Velocities, m/s.
    pub velocity: Option<Vec<[f64; 2]>>,
    /// Nodal forces (internal, joints, contact, edge loads), N.
    pub force: Option<Vec<[f64; 2]>>,
    /// Nodal masses, kg.
    pub mass: Option<Vec<f64>>,
    /// Node set of each node.
    pub node_set: Option<Vec<i32>>,
    /// Corners of the triangles.
    pub triangles: Vec<[u32; 3]>,
    /// Property (material) of each triangle, as the deck counts: from 0.
    pub property: Vec<i32>,
    /// Body of each triangle.
    pub body: Option<Vec<i32>>,
    /// Cauchy stress of each triangle, xx, yy, zz, xy, Pa, tension positive.
    pub stress: Option<Vec<[f64; 4]>>,
    /// Damage of each triangle.
    pub damage: Option<Vec<f64>>,
    /// Joints.
    pub joints: Vec<Joint>,
}

impl Frame {
    /// Where the nodes were at the start, m: where they are now if no displacements are known.
    #[must_use]
    pub fn initial(&self) -> Vec<[f64; 2]> {
        match &self.displacement {
            Some(moved) => self.points.iter().zip(moved).map(|(x, u)| minus(*x, *u)).collect(),
            None => self.points.clone(),
        }
    }

    /// Stress of triangle `index` as a tensor.
    #[must_use]
    pub fn stress_of(&self, index: usize) -> Option<SymmetricTensor> {
        let &[xx, yy, zz, xy] = self.stress.as_ref()?.get(index)?;
        Some(plane(xx, yy, zz, xy))
    }

    /// Corners of a triangle among `points`.
    #[must_use]
    pub fn corners(triangle: [u32; 3], points: &[[f64; 2]]) -> [[f64; 2]; 3] {
        triangle.map(|n| points.get(n as usize).copied().unwrap_or([f64::NAN; 2]))
    }

    /// Kinetic energy: of masses and velocities where both are known, or as the file tells it.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        match (&self.mass, &self.velocity) {
            (Some(mass), Some(velocity)) => {
                let each = mass.iter().zip(velocity);
                Some(each.map(|(m, v)| 0.5 * m * (v[0] * v[0] + v[1] * v[1])).sum())
            }
            _ => self.kinetic_energy,
        }
    }

    /// Smallest and largest coordinates, m.
    ///
    /// # Errors
    /// If no node has finite coordinates.
    pub fn bounds(points: &[[f64; 2]]) -> Result<[[f64; 2]; 2], PostError> {
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
            for axis in 0..2 {
                bounds[0][axis] = bounds[0][axis].min(point[axis]);
                bounds[1][axis] = bounds[1][axis].max(point[axis]);
            }
        }
        if bounds[0][0] <= bounds[1][0] {
            Ok(bounds)
        } else {
            Err(PostError::Nothing("no node has finite coordinates".to_owned()))
        }
    }

    /// Every triangle and every array must fit the points.
    pub(super) fn check(&self) -> Result<(), String> {
        let points = self.points.len();
        let worst = self.triangles.iter().flatten().max();
        if let Some(node) = worst.filter(|&&node| node as usize >= points) {
            return Err(format!("a triangle names node {node}; nodes run from 0 to {points} - 1"));
        }
        let lengths = [
            ("displacements", self.displacement.as_ref().map(Vec::len), points),
            ("velocities", self.velocity.as_ref().map(Vec::len), points),
            ("forces", self.force.as_ref().map(Vec::len), points),
            ("masses", self.mass.as_ref().map(Vec::len), points),
            ("node sets", self.node_set.as_ref().map(Vec::len), points),
            ("properties", Some(self.property.len()), self.triangles.len()),
            ("bodies", self.body.as_ref().map(Vec::len), self.triangles.len()),
            ("stresses", self.stress.as_ref().map(Vec::len), self.triangles.len()),
            ("damages", self.damage.as_ref().map(Vec::len), self.triangles.len()),
        ];
        for (name, found, expected) in lengths {
            if let Some(found) = found.filter(|&found| found != expected) {
                return Err(format!("there are {found} {name}; expected {expected}"));
            }
        }
        Ok(())
    }
}

pub(crate) fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
