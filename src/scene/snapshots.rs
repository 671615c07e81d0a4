/// Numbers and scales of `.ym` snapshots and restart decks (classic).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SnapshotSettings {
    /// Scale of coordinates, m.
    pub coordinate: f64,
    /// Scale of forces, N.
    pub force: f64,
    /// Scale of stresses, Pa.
    pub stress: f64,
    /// Scale of velocities, m/s.
    pub velocity: f64,
    /// Scale of shear displacement and dilation, m.
    pub displacement: f64,
    /// Base of the logarithmic scale of apertures, m.
    pub aperture: f64,
    /// Characters per number.
    pub digits: u8,
    /// Number of the first snapshot.
    pub first_number: u64,
    /// Restart decks are written every so many steps; 0: none.
    pub restart_interval: u64,
}
