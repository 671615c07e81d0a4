//! Results on disk, as one model: bodies of triangles, joints, values at one time.

mod d3plot;
mod frame;
mod series;
mod vtk;

pub use frame::{Frame, Joint, JointState};
pub use series::{FrameChoice, Results};
