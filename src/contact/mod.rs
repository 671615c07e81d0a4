//! Contact: when and between which elements it is looked for, the list of
//! couples, and the potential force of one couple.

mod bodies;
mod bonds;
mod certain;
mod chunk;
mod clearance;
mod couples;
mod detection;
mod edges;
mod evaluation;
mod exertion;
mod friction;
mod in_order;
mod interaction;
mod locate;
mod overlap2;
mod placement;
mod places;
mod profile;
pub mod spatial;
mod sweep;
mod visits;

pub use bonds::Bonds;
pub use clearance::{Clearance, clearance};
pub use couples::CoupleList;
pub use detection::{Detector, Participants};
pub use friction::PairTable;
pub use in_order::{FractureFace, FractureFaces, Tally};
pub use interaction::{Contact, ContactState, CoupleWork};
pub use overlap2::{Couple, EdgeContact, Proximity, SideForces, TangentialLaw, overlap};
pub use placement::{AreaCoordinates, Lanes, Motion, Shape};
