//! The frame of the triangles and that of their principal directions.

use std::io::{self, Write};
use std::iter::repeat_n;

use super::principal::PrincipalStress;
use super::vtk_xml::{self, SIX, single};

/// What one triangle shows in an output step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementState {
    /// Its corners, as indices into the points of the frame.
    pub corners: [usize; 3],
    /// Stress, tension positive, `[[xx, xy], [yx, yy]]`, from the coordinates and velocities
    /// after the step.
    pub stress: [[f64; 2]; 2],
    /// Half of (left Cauchy-Green tensor minus identity), as Y takes it for strain.
    pub strain: [[f64; 2]; 2],
    /// Index of its material, from 0.
    pub property: i32,
}

/// The points and triangles of an output step.
///
/// The points are the nodes that have mass, in the order of their numbers: meshing leaves the
/// deck's own nodes behind without mass. All slices over points have the same length.
///
/// Y-Geo makes room for three points per triangle, as if no two triangles shared a node, and
/// leaves the rest as the memory happened to be, mostly zero; here the rest is zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementFrame<'a> {
    /// Coordinates after the step.
    pub coordinates: &'a [[f64; 2]],
    /// Coordinates when forces were first computed, from which displacements count.
    pub reference_coordinates: &'a [[f64; 2]],
    /// Velocities after the step.
    pub velocities: &'a [[f64; 2]],
    /// Total nodal forces of the step.
    pub forces: &'a [[f64; 2]],
    /// Pressure of the fluid at wet nodes, zero elsewhere; empty when there is no hydrofracture.
    pub fluid_pressures: &'a [f64],
    /// The triangles, in Y-Geo in ascending order of their property, then of their number.
    pub elements: &'a [ElementState],
}

/// Why a frame cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum ElementFrameError {
    /// A slice over points has another length than the coordinates.
    #[error("the frame has {points} points but {found} {quantity}; give one for every point")]
    Length {
        /// Number of coordinates.
        points: usize,
        /// What there are too few or too many of.
        quantity: &'static str,
        /// How many there are.
        found: usize,
    },
    /// A triangle has a corner that is not among the points.
    #[error("triangle {element} has corner {corner}, but the frame has {points} points only")]
    Corner {
        /// Index of the triangle in the frame.
        element: usize,
        /// The corner.
        corner: usize,
        /// Number of points.
        points: usize,
    },
    /// The output refused.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl ElementFrame<'_> {
    /// Writes `PREFIX_N.vtp` (outputs.md, 5.1).
    ///
    /// Nothing is written when the slices do not fit together.
    pub fn write(&self, out: &mut impl Write) -> Result<(), ElementFrameError> {
        self.check()?;
        let room = self.coordinates.len().max(3 * self.elements.len());
        vtk_xml::open_poly_data(out, room, self.elements.len())?;
        vtk_xml::points(out, padded(self.coordinates.iter().copied(), room))?;
        self.write_point_data(out, room)?;
        self.write_cell_data(out)?;
        let connectivity = self.elements.iter().flat_map(|element| element.corners);
        let offsets = (1..=self.elements.len()).map(|element| 3 * element);
        Ok(vtk_xml::close_poly_data(out, connectivity, offsets)?)
    }

    /// Writes `PREFIX_principal_direction_N.vtu` (outputs.md, 5.2): the principal directions of
    /// the stress at the centroids of the triangles.
    ///
    /// Nothing is written when the slices do not fit together.
    pub fn write_principal_directions(
        &self,
        out: &mut impl Write,
    ) -> Result<(), ElementFrameError> {
        self.check()?;
        vtk_xml::open_point_cloud(out, self.elements.len())?;
        out.write_all(
            b"<PointData Vectors='principal_stress_direction_1 principal_stress_direction_2'>\n",
        )?;
        let principal = || self.elements.iter().map(|element| PrincipalStress::of(element.stress));
        let larger = principal().map(|stress| stress.larger_direction);
        vtk_xml::vector_array(out, "principal_stress_direction_1", larger)?;
        let smaller = principal().map(|stress| stress.smaller_direction);
        vtk_xml::vector_array(out, "principal_stress_direction_2", smaller)?;
        out.write_all(b"</PointData>\n")?;
        let centroids = self.elements.iter().map(|element| single(self.centroid(element)));
        Ok(vtk_xml::close_point_cloud(out, centroids)?)
    }

    fn write_point_data(&self, out: &mut impl Write, room: usize) -> io::Result<()> {
        out.write_all(b"<PointData Vectors='velocity force displacement'>\n")?;
        vtk_xml::vector_array(out, "velocity", padded(self.velocities.iter().copied(), room))?;
        vtk_xml::vector_array(out, "force", padded(self.forces.iter().copied(), room))?;
        let displacements = self
            .coordinates
            .iter()
            .zip(self.reference_coordinates)
            .map(|(now, then)| [now[0] - then[0], now[1] - then[1]]);
        vtk_xml::vector_array(out, "displacement", padded(displacements, room))?;
        let dry = room.saturating_sub(self.fluid_pressures.len());
        let pressures = self.fluid_pressures.iter().map(|&pressure| pressure as f32);
        let pressures = pressures.chain(repeat_n(0.0, dry));
        vtk_xml::float_array(out, "fluid pressure", SIX, pressures)?;
        out.write_all(b"</PointData>\n")
    }

    fn write_cell_data(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(
            b"<CellData Tensors='stress strain principal_stress' \
            Vectors='principal_stress_direction_1 principal_stress_direction_2' \
            Scalars='property_id'>\n",
        )?;
        let elements = || self.elements.iter();
        vtk_xml::tensor_array(out, "stress", elements().map(|element| rows(element.stress)))?;
        vtk_xml::tensor_array(out, "strain", elements().map(|element| rows(element.strain)))?;
        let principal = elements().map(|element| {
            let stress = PrincipalStress::of(element.stress);
            [stress.minimum(), 0.0, 0.0, stress.maximum()]
        });
        vtk_xml::tensor_array(out, "principal_stress", principal)?;
        vtk_xml::integer_array(out, "property_id", elements().map(|element| element.property))?;
        out.write_all(b"\n</CellData>\n")
    }

    /// Of a triangle whose corners [`ElementFrame::check`] has seen.
    fn centroid(&self, element: &ElementState) -> [f64; 2] {
        let [a, b, c] = element.corners.map(|corner| self.coordinates[corner]);
        [0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0)
    }

    fn check(&self) -> Result<(), ElementFrameError> {
        let points = self.coordinates.len();
        let lengths = [
            ("reference coordinates", self.reference_coordinates.len()),
            ("velocities", self.velocities.len()),
            ("forces", self.forces.len()),
            ("fluid pressures", self.fluid_pressures.len()),
        ];
        for (quantity, found) in lengths {
            if found != points && !(quantity == "fluid pressures" && found == 0) {
                return Err(ElementFrameError::Length { points, quantity, found });
            }
        }
        for (element, state) in self.elements.iter().enumerate() {
            if let Some(&corner) = state.corners.iter().find(|&&corner| corner >= points) {
                return Err(ElementFrameError::Corner { element, corner, points });
            }
        }
        Ok(())
    }
}

/// Vectors in single precision, followed by zeros to fill the room.
fn padded(
    vectors: impl ExactSizeIterator<Item = [f64; 2]>,
    room: usize,
) -> impl Iterator<Item = [f32; 2]> {
    let rest = room.saturating_sub(vectors.len());
    vectors.map(single).chain(repeat_n([0.0; 2], rest))
}

fn rows([[xx, xy], [yx, yy]]: [[f64; 2]; 2]) -> [f32; 4] {
    [xx, xy, yx, yy].map(|component| component as f32)
}
