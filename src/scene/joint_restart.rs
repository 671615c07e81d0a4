use crate::mechanics::aperture::Aperture;

/// State of joints that a restart deck of the classic dialect brings along.
#[derive(Debug, Clone, PartialEq)]
pub struct JointRestart {
    /// Shear strengths at the three points of each element, Pa.
    pub strengths: Option<Vec<[f64; 3]>>,
    /// State of the fractures, one for each joint.
    pub apertures: Vec<Aperture>,
}
