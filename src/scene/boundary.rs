use crate::mechanics::{tetrahedron, triangle};
use nalgebra::{Matrix2, SMatrix};

/// What a node set prescribes along one local axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// The amplitude is a nodal force, N.
    Force,
    /// The amplitude is an acceleration added to that of the forces, m/s².
    Acceleration,
    /// The amplitude is the velocity itself, m/s.
    Velocity,
    /// As [`Self::Force`], and edges between two such nodes damp the motion as if
    /// the material went on behind them (Y-Geo).
    Absorbing,
    /// The velocity component keeps its value whatever the forces (code −1,
    /// the default of the original in 2D).
    Frozen,
}

/// Boundary conditions of one node set.
#[derive(Debug, Clone, PartialEq)]
pub struct NodeSet<const D: usize> {
    /// Condition along each local axis.
    pub conditions: [Condition; D],
    /// Amplitude along each local axis, in the unit of the condition.
    pub amplitudes: [f64; D],
    /// Acceleration on top of gravity along the global axes, m/s² (`.Y3D`).
    pub acceleration: [f64; D],
    /// Pressure on edges whose two nodes both belong to loaded sets, Pa,
    /// positive into the body.
    pub pressure: f64,
    /// Traction along such edges, Pa, positive counter-clockwise.
    pub traction: f64,
    /// Factor on pressure and traction at the start; the load history where there
    /// is one.
    pub edge_factor: f64,
    /// What is added to that factor in each step (classic).
    pub edge_factor_step: f64,
    /// Columns are the local axes.
    pub axes: SMatrix<f64, D, D>,
    /// Whether its nodes are moved at all: in the classic dialect only sets of
    /// the type of nodes are.
    pub moves: bool,
}

impl NodeSet<2> {
    /// Inverse of the matrix of the local axes.
    #[must_use]
    pub fn inverse_axes(&self) -> SMatrix<f64, 2, 2> {
        let axes = &self.axes;
        let determinant = axes[(0, 0)] * axes[(1, 1)] - axes[(1, 0)] * axes[(0, 1)];
        triangle::inverse(axes, determinant)
    }
}

impl NodeSet<3> {
    /// Inverse of the matrix of the local axes.
    #[must_use]
    pub fn inverse_axes(&self) -> SMatrix<f64, 3, 3> {
        tetrahedron::inverse(&self.axes, tetrahedron::determinant(&self.axes))
    }
}

/// Staged loading of the classic dialect: nothing until the scene has settled,
/// then a linear rise (spec `mechanics.md` 3.1).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LoadRamp {
    /// Time at which loads begin to rise, s.
    pub start: f64,
    /// Duration of the rise, s.
    pub duration: f64,
}

impl LoadRamp {
    /// Factor on all loads but gravity at `time`.
    #[must_use]
    pub fn factor(&self, time: f64) -> f64 {
        if time < self.start {
            0.0
        } else if time < self.start + self.duration {
            (time - self.start) / self.duration
        } else {
            1.0
        }
    }
}

/// Stress that the ground is under from the start (Y-Geo, spec `mechanics.md` 7.3).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InSituStress {
    /// σxx, σxy, σyy at the surface, Pa, positive in compression.
    pub at_surface: [f64; 3],
    /// Their change with the height above the surface, Pa/m.
    pub gradient: [f64; 3],
    /// Height of the surface, m.
    pub surface: f64,
}

impl InSituStress {
    /// Stress at a height, Pa, positive in tension.
    #[must_use]
    pub fn at(&self, height: f64) -> Matrix2<f64> {
        let above = height - self.surface;
        let component = |k: usize| -self.at_surface[k] - self.gradient[k] * above;
        Matrix2::new(component(0), component(1), component(1), component(2))
    }
}

/// Factor on the amplitudes of each node set as a function of time.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadHistory {
    /// `(time, factor)` points of each node set.
    pub points: Vec<Vec<(f64, f64)>>,
}

impl LoadHistory {
    /// Factor of node set `set` at `time`: linear between the points, the
    /// later interval where two meet, and **1 outside the table** (spec
    /// `y2d3d.md` C.1).
    #[must_use]
    pub fn factor(&self, set: usize, time: f64) -> f64 {
        let mut factor = 1.0;
        for pair in self.points[set].windows(2) {
            let ((t0, f0), (t1, f1)) = (pair[0], pair[1]);
            if t0 <= time && time <= t1 {
                factor = f0 - (f0 - f1) * ((time - t0) / (t1 - t0));
            }
        }
        factor
    }

    /// Factor of node set `set` at `time` in 3D (spec `y2d3d.md` F.3): linear between the points,
    /// the first interval that begins at `time` or before it and ends later; of a single point
    /// its value. `None` outside the table, where the original stops.
    #[must_use]
    pub fn factor_within(&self, set: usize, time: f64) -> Option<f64> {
        if let [(_, factor)] = self.points[set][..] {
            return Some(factor);
        }
        self.points[set].windows(2).find_map(|pair| {
            let ((t0, f0), (t1, f1)) = (pair[0], pair[1]);
            (t0 <= time && time < t1).then(|| f0 + (f1 - f0) * (time - t0) / (t1 - t0))
        })
    }

    /// Whether the table is in force: the original ignores it if the first
    /// time of the first set is −1.
    #[must_use]
    pub fn is_active(&self) -> bool {
        self.points.first().and_then(|p| p.first()).is_some_and(|p| p.0 != -1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::LoadHistory;

    #[test]
    fn factor_is_linear_inside_and_one_outside() {
        let history = LoadHistory { points: vec![vec![(0.0, 0.5), (0.01, 2.0), (0.055, -1.0)]] };
        assert_eq!(history.factor(0, 0.0), 0.5);
        assert!((history.factor(0, 0.005) - 1.25).abs() < 1e-15);
        assert_eq!(history.factor(0, 0.01), 2.0);
        assert_eq!(history.factor(0, 0.06), 1.0);
        assert_eq!(history.factor(0, -1.0), 1.0);
    }
}
