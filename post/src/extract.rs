//! Tables from results.

mod energies;
mod extremes;
mod force_displacement;
mod histories;
mod joints;
mod lines;
mod locate;
mod top_line;

pub use energies::energy;
pub use extremes::extremes;
pub use force_displacement::force_displacement;
pub use histories::{Place, histories};
pub use joints::joint_counts;
pub use lines::{Path, along};
pub use locate::{Locator, nearest_corner};
pub use top_line::top_line;
