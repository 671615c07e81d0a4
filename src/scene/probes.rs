/// Quantity recorded by a history output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProbeQuantity {
    /// σxx of the elastic triangle around the point, Pa.
    StressXx,
    /// σxy, Pa.
    StressXy,
    /// σyy, Pa.
    StressYy,
    /// Out-of-plane stress components: always 0 in 2D.
    StressOutOfPlane,
    /// Mean speed of the triangle's nodes, m/s.
    Speed,
    /// Mean x velocity of the triangle's nodes, m/s.
    VelocityX,
    /// Mean y velocity of the triangle's nodes, m/s.
    VelocityY,
    /// Kinetic energy of the whole scene, J.
    KineticEnergy,
    /// Nodal x force at the node with exactly these initial coordinates, N.
    ForceX,
    /// Nodal y force, N.
    ForceY,
    /// Elastic energy of all triangles, J (Y-Geo).
    StrainEnergy,
    /// A code that the original names or accepts but never updates.
    NeverUpdated(i64),
}

impl ProbeQuantity {
    /// Whether it belongs to the elastic triangle around the point.
    #[must_use]
    pub fn is_elemental(self) -> bool {
        use ProbeQuantity::{
            Speed, StressOutOfPlane, StressXx, StressXy, StressYy, VelocityX, VelocityY,
        };
        matches!(
            self,
            StressXx | StressXy | StressYy | StressOutOfPlane | Speed | VelocityX | VelocityY
        )
    }
}

/// A history output.
#[derive(Debug, Clone, PartialEq)]
pub struct Probe {
    /// What is recorded.
    pub quantity: ProbeQuantity,
    /// Where, in initial coordinates, m.
    pub point: [f64; 2],
    /// Value before the first update.
    pub initial_value: f64,
    /// Time that the value before the first update is of, s.
    pub initial_time: f64,
    /// Factor on the time when written.
    pub time_factor: f64,
    /// Factor on the value when written.
    pub value_factor: f64,
}
