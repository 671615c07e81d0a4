/// Pressure on a face of a tetrahedron (`.Y3D`, spec `y3d.md` 1.7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FacePressure {
    /// The tetrahedron.
    pub element: usize,
    /// Which of its corners make the face, counter-clockwise seen from outside.
    pub corners: [u8; 3],
    /// Pressure, Pa, positive into the body.
    pub pressure: f64,
}
