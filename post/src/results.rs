//! Results on disk, as one model: bodies of triangles or tetrahedra, joints, values at one
//! time.

mod d3plot;
mod frame;
mod series;
mod vtk;

pub(crate) use frame::element_name;
pub use frame::{Frame, Joint, JointState};
pub(crate) use series::by_dimension;
pub use series::{FrameChoice, Results};

pub use crate::vectors::bounds;
