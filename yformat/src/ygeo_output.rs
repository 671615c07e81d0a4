//! The result files of the Y-Geo dialect: seven VTK XML files per output step and text files.
//!
//! Every writer takes plain values in double precision and a [`std::io::Write`] (wrap files in a
//! [`std::io::BufWriter`]; numbers are formatted one at a time) and gives the bytes that Y-Geo
//! gives: values are rounded to single precision first, then printed with six decimals (nine for
//! the gaps of joints). What Y-Geo computes on the way to a file is computed here with the same
//! roundings: [`PrincipalStress`], [`JointGap`], [`AcousticEvent::magnitude`].
//!
//! | file | writer |
//! |---|---|
//! | `wall.y_N.vtp` | [`ElementFrame::write`] |
//! | `wall.y_principal_direction_N.vtu` | [`ElementFrame::write_principal_directions`] |
//! | `wall.y_broken_joints_N.vtp` | [`write_broken_joints`] |
//! | `wall.y_yielded_joints_N.vtp` | [`write_yielded_joints`] |
//! | `wall.y_acoustic_N.vtu` | [`write_acoustic_events`] |
//! | `wall.y_rebars_N.vtp` | [`write_rebars`] |
//! | `wall.y_1D_joints_N.vtp` | [`write_one_dimensional_joints`] |
//! | `wall.yh<k>` | [`write_history_point`] |
//! | `wall.yhBRK`, `wall.yhSFT` | [`BreakageRecord::write`], [`YieldRecord::write`] |
//! | `wall.yhFRAC`, `wall.yhHF` | [`FractureTotals::write`], [`HydrofracturePoint::write`] |
//! | `wall.yres<k>` | [`RestartFragment::write`] |
//!
//! [`ResultFile`] and [`TextFile`] make the names. Y-Geo opens the text files to append, an old
//! one is continued; of the seven frames all are written at every output step, empty ones too.
//!
//! ```
//! use yformat::ygeo_output::{BrokenJoint, write_broken_joints};
//!
//! let joint = BrokenJoint {
//!     corners: [[0.0, 0.01], [1.0, 0.01], [1.0, 0.0], [0.0, 0.0]],
//!     failure_mode: 1.0,
//!     neighbour_excavated: false,
//! };
//! let mut file = Vec::new();
//! write_broken_joints(&mut file, &[joint])?;
//! let text = String::from_utf8(file)?;
//! assert!(text.contains("'broken_opening' NumberOfComponents='1' format='ascii'>\n0.010000000 "));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod acoustic;
mod elements;
mod events;
mod gap;
mod joints;
mod names;
mod principal;
mod reinforcement;
mod restart;
mod series;
mod vtk_xml;

pub use acoustic::{AcousticEvent, write_acoustic_events};
pub use elements::{ElementFrame, ElementFrameError, ElementState};
pub use events::{BreakageRecord, YieldRecord};
pub use gap::JointGap;
pub use joints::{BrokenJoint, YieldMode, YieldedJoint, write_broken_joints, write_yielded_joints};
pub use names::{ResultFile, TextFile};
pub use principal::PrincipalStress;
pub use reinforcement::{
    OneDimensionalJoint, RebarSegment, write_one_dimensional_joints, write_rebars,
};
pub use restart::RestartFragment;
pub use series::{FractureTotals, HydrofracturePoint, write_history_point};
