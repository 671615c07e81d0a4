//! Contact: when and between which elements it is looked for, the list of
//! couples, and the potential force of one couple.

mod clearance;
mod couples;
mod detection;
mod evaluation;
mod friction;
mod interaction;
mod overlap2;
mod placement;
mod profile;
mod visits;

pub use clearance::clearance;
pub use couples::CoupleList;
pub use detection::{Detector, Participants};
pub use friction::{PairProperties, PairTable};
pub use interaction::{Contact, CoupleWork};
pub use overlap2::{Couple, Proximity, SideForces, overlap};
pub use placement::{AreaCoordinates, Lanes, Motion, Shape};
