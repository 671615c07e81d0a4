//! The frames of broken and of yielded joints.

use std::io::{self, Write};

use super::gap::JointGap;
use super::vtk_xml::{self, NINE, SIX, single};

/// A joint in the frame of broken joints: broken, part of the discrete fracture network,
/// excavated, or at the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BrokenJoint {
    /// Present coordinates of its four corners. At the boundary 3 is 0 and 2 is 1.
    pub corners: [[f64; 2]; 4],
    /// 0 boundary or fracture network, 1 opened, 2 slid, 3 both, between 1 and 2 mixed, 4
    /// excavated, 5 fracture network of type 3, broken.
    pub failure_mode: f64,
    /// Whether a triangle beside it is excavated: its gap is reported as zero then.
    ///
    /// For the missing neighbour of a boundary joint Y-Geo reads in front of an array. Nearly
    /// always that means "not excavated"; where it means the other the zeros have no signs.
    pub neighbour_excavated: bool,
}

impl BrokenJoint {
    /// The gap that the frame shows.
    #[must_use]
    pub fn gap(&self) -> JointGap {
        if self.neighbour_excavated { JointGap::default() } else { JointGap::between(self.corners) }
    }
}

/// How a joint yielded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum YieldMode {
    /// Beyond the elastic opening.
    Opening,
    /// Beyond the elastic sliding.
    Sliding,
    /// Beyond both.
    Mixed,
}

impl YieldMode {
    /// The mode that the yield flag of Y-Geo's joints means: 1 mixed, 2 opening, 3 sliding.
    #[must_use]
    pub fn from_flag(flag: i64) -> Option<Self> {
        match flag {
            1 => Some(Self::Mixed),
            2 => Some(Self::Opening),
            3 => Some(Self::Sliding),
            _ => None,
        }
    }

    /// The number in the files: 1 opening, 2 sliding, 3 both.
    #[must_use]
    pub fn code(self) -> i32 {
        match self {
            Self::Opening => 1,
            Self::Sliding => 2,
            Self::Mixed => 3,
        }
    }
}

/// A joint that has yielded and is not broken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldedJoint {
    /// Present coordinates of its four corners, as for [`BrokenJoint`].
    pub corners: [[f64; 2]; 4],
    /// How it yielded.
    pub mode: YieldMode,
}

/// Writes `PREFIX_broken_joints_N.vtp` (outputs.md, 5.3).
///
/// Y-Geo has the joints in ascending order of their property, then of their number. Each joint
/// becomes two flat quadrilaterals, one per side, with the same values.
pub fn write_broken_joints(out: &mut impl Write, joints: &[BrokenJoint]) -> io::Result<()> {
    open(out, joints.iter().map(|joint| joint.corners))?;
    out.write_all(b"<CellData Scalars='broken_mode_of_failure'>\n")?;
    let mut scalars = |name, decimals, value: fn(&BrokenJoint) -> f32| {
        let values = joints.iter().flat_map(|joint| [value(joint); 2]);
        vtk_xml::float_array(out, name, decimals, values)
    };
    scalars("broken_mode_of_failure", SIX, |joint| joint.failure_mode as f32)?;
    scalars("broken_sliding", NINE, |joint| joint.gap().sliding)?;
    scalars("broken_opening", NINE, |joint| joint.gap().opening)?;
    scalars("broken_area", NINE, |joint| joint.gap().area)?;
    close(out, joints.len())
}

/// Writes `PREFIX_yielded_joints_N.vtp` (outputs.md, 5.4), laid out as
/// [`write_broken_joints`] does.
pub fn write_yielded_joints(out: &mut impl Write, joints: &[YieldedJoint]) -> io::Result<()> {
    open(out, joints.iter().map(|joint| joint.corners))?;
    out.write_all(b"<CellData Scalars='yielded_mode_of_failure'>\n")?;
    let modes = joints.iter().flat_map(|joint| [joint.mode.code(); 2]);
    vtk_xml::integer_array(out, "yielded_mode_of_failure", modes)?;
    close(out, joints.len())
}

/// Everything up to the cell data: per joint the points 0, 0, 1, 1, 2, 2, 3, 3.
fn open(
    out: &mut impl Write,
    joints: impl ExactSizeIterator<Item = [[f64; 2]; 4]>,
) -> io::Result<()> {
    vtk_xml::open_poly_data(out, 8 * joints.len(), 2 * joints.len())?;
    let twice = |corner| [single(corner); 2];
    vtk_xml::points(out, joints.flat_map(|corners| corners.into_iter().flat_map(twice)))?;
    out.write_all(b"<PointData>\n</PointData>\n")
}

fn close(out: &mut impl Write, joints: usize) -> io::Result<()> {
    out.write_all(b"\n</CellData>\n")?;
    vtk_xml::close_poly_data(out, 0..8 * joints, (1..=2 * joints).map(|side| 4 * side))
}
