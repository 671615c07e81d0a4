//! One state: owned as read from a file, or borrowed from a computation.

/// A state read from a family. Lengths follow the control block; parts that a file leaves out
/// are empty.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct State {
    /// Time.
    pub time: f32,
    /// Global values; Y fills the first with the kinetic energy.
    pub globals: Vec<f32>,
    /// Current coordinates.
    pub coordinates: Vec<[f32; 3]>,
    /// Velocities.
    pub velocities: Vec<[f32; 3]>,
    /// What the file calls accelerations; Y puts nodal joint forces there (zero in 2D).
    pub accelerations: Vec<[f32; 3]>,
    /// Values of the solids, NV3D each: Y writes σxx σyy σzz σxy σyz σxz 0.
    pub solid_data: Vec<f32>,
    /// Values of the shells, NV2D each: Y writes σxx σyy σzz σxy σyz σxz.
    pub shell_data: Vec<f32>,
    /// Deletion table, one entry per element (solids, then shells): 0 for a broken joint, else
    /// the material.
    pub deletion_table: Vec<f32>,
}

/// A state about to be written, in the single precision of the format.
#[derive(Debug, Clone, Copy)]
pub struct StateView<'a> {
    /// Time.
    pub time: f64,
    /// Kinetic energy; the other global values are written as zeros.
    pub kinetic_energy: f64,
    /// Current coordinates.
    pub coordinates: NodeVectors<'a>,
    /// Velocities.
    pub velocities: NodeVectors<'a>,
    /// What the file calls accelerations: nodal joint forces in 3D, zero in 2D.
    pub accelerations: NodeVectors<'a>,
    /// Stresses of the elements in the order of the geometry.
    pub stresses: Stresses<'a>,
    /// One value per element: its material, 0 for a broken joint.
    pub deletion_table: &'a [f32],
}

/// One vector per node.
#[derive(Debug, Clone, Copy)]
pub enum NodeVectors<'a> {
    /// Zero everywhere.
    Zero,
    /// Two components per node; the third is 0.
    Plane(&'a [[f32; 2]]),
    /// Three components per node.
    Spatial(&'a [[f32; 3]]),
}

/// One stress per element.
#[derive(Debug, Clone, Copy)]
pub enum Stresses<'a> {
    /// Zero everywhere.
    Zero,
    /// σxx σyy σxy per element; the other components are 0.
    Plane(&'a [[f32; 3]]),
    /// σxx σyy σzz σxy σyz σxz per element.
    Spatial(&'a [[f32; 6]]),
}

impl NodeVectors<'_> {
    /// How many vectors there are; `None` for [`NodeVectors::Zero`], which fits any number.
    pub(super) fn len(&self) -> Option<usize> {
        match self {
            Self::Zero => None,
            Self::Plane(vectors) => Some(vectors.len()),
            Self::Spatial(vectors) => Some(vectors.len()),
        }
    }
}

impl Stresses<'_> {
    /// How many stresses there are; `None` for [`Stresses::Zero`], which fits any number.
    pub(super) fn len(&self) -> Option<usize> {
        match self {
            Self::Zero => None,
            Self::Plane(stresses) => Some(stresses.len()),
            Self::Spatial(stresses) => Some(stresses.len()),
        }
    }
}
