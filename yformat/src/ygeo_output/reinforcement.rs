//! The frames of rebars and of the one-dimensional joints between them.

use std::io::{self, Write};

use super::vtk_xml::{self, SIX, single};

/// A piece of a rebar between two edges of one triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RebarSegment {
    /// Present coordinates of its ends.
    pub ends: [[f64; 2]; 2],
    /// Cross section.
    pub area: f64,
    /// Axial stress, tension positive.
    pub stress: f64,
    /// Axial force.
    pub force: f64,
    /// Axial strain.
    pub strain: f64,
    /// Whether it acts yet: 1, else 0.
    pub activation_flag: i32,
}

/// A joint of a rebar where it crosses an edge of the mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OneDimensionalJoint {
    /// Present coordinates of its ends.
    pub ends: [[f64; 2]; 2],
    /// Axial stress, tension positive.
    pub axial_stress: f64,
    /// Shear stress.
    pub shear_stress: f64,
    /// Axial displacement (length).
    pub axial_displacement: f64,
    /// Shear displacement (length).
    pub shear_displacement: f64,
    /// State of the joint, as Y-Geo numbers it.
    pub state: i32,
}

/// Writes `PREFIX_rebars_N.vtp` (outputs.md, 5.6): each segment one flat quadrilateral.
pub fn write_rebars(out: &mut impl Write, segments: &[RebarSegment]) -> io::Result<()> {
    open(out, segments.iter().map(|segment| segment.ends))?;
    out.write_all(b"<CellData Scalars='rebar_diameter'>\n")?;
    let mut scalars = |name, value: fn(&RebarSegment) -> f64| {
        vtk_xml::float_array(out, name, SIX, segments.iter().map(|segment| value(segment) as f32))
    };
    scalars("rebar_area", |segment| segment.area)?;
    scalars("rebar_stress", |segment| segment.stress)?;
    scalars("rebar_force", |segment| segment.force)?;
    scalars("rebar_strain", |segment| segment.strain)?;
    let flags = segments.iter().map(|segment| segment.activation_flag);
    vtk_xml::integer_array(out, "rebar_activation_flag", flags)?;
    close(out, segments.len())
}

/// Writes `PREFIX_1D_joints_N.vtp` (outputs.md, 5.6), laid out as [`write_rebars`] does.
pub fn write_one_dimensional_joints(
    out: &mut impl Write,
    joints: &[OneDimensionalJoint],
) -> io::Result<()> {
    open(out, joints.iter().map(|joint| joint.ends))?;
    out.write_all(b"<CellData Scalars='1D_joint_stress'>\n")?;
    let mut scalars = |name, value: fn(&OneDimensionalJoint) -> f64| {
        vtk_xml::float_array(out, name, SIX, joints.iter().map(|joint| value(joint) as f32))
    };
    scalars("1D_joint_axial_stress", |joint| joint.axial_stress)?;
    scalars("1D_joint_shear_stress", |joint| joint.shear_stress)?;
    scalars("1D_joint_axial_displacement", |joint| joint.axial_displacement)?;
    scalars("1D_joint_shear_displacement", |joint| joint.shear_displacement)?;
    vtk_xml::integer_array(out, "1D_joint_state", joints.iter().map(|joint| joint.state))?;
    close(out, joints.len())
}

/// Everything up to the cell data: per line the points 0, 0, 1, 1.
fn open(
    out: &mut impl Write,
    lines: impl ExactSizeIterator<Item = [[f64; 2]; 2]>,
) -> io::Result<()> {
    vtk_xml::open_poly_data(out, 4 * lines.len(), lines.len())?;
    let twice = |end| [single(end); 2];
    vtk_xml::points(out, lines.flat_map(|ends| ends.into_iter().flat_map(twice)))?;
    out.write_all(b"<PointData>\n</PointData>\n")
}

fn close(out: &mut impl Write, lines: usize) -> io::Result<()> {
    out.write_all(b"\n</CellData>\n")?;
    vtk_xml::close_poly_data(out, 0..4 * lines, (1..=lines).map(|line| 4 * line))
}
