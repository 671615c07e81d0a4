use nalgebra::SMatrix;

/// What a node set prescribes along one local axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Condition {
    /// The amplitude is a nodal force, N.
    Force,
    /// The amplitude is an acceleration added to that of the forces, m/s².
    Acceleration,
    /// The amplitude is the velocity itself, m/s.
    Velocity,
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
    /// Pressure on edges whose two nodes both belong to loaded sets, Pa,
    /// positive into the body.
    pub pressure: f64,
    /// Traction along such edges, Pa, positive counter-clockwise.
    pub traction: f64,
    /// Columns are the local axes.
    pub axes: SMatrix<f64, D, D>,
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
