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
mod facing;
mod friction;
mod in_order;
mod interaction;
mod locate;
mod overlap2;
mod placement;
mod places;
mod profile;
mod respites;
mod sliding;
pub mod spatial;
mod sweep;
mod visits;

use couples::CoupleList;

pub use bonds::Bonds;
pub use clearance::{Clearance, clearance};
pub use friction::PairTable;
pub use in_order::{FractureFace, FractureFaces, Tally};
pub use interaction::{Contact, ContactState, CoupleWork};
pub use overlap2::{Couple, EdgeContact, Proximity, SideForces, TangentialLaw, overlap};
pub use placement::{AreaCoordinates, Lanes, Motion, Shape};
