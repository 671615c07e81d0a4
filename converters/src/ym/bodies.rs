//! Triangles as a grid.

use yformat::ym::{CodedRecord, Record, Scales, Triangle};

use crate::vtk::{CellType, Cells, DataArray, UnstructuredGrid};

/// The grid that shows these records; others than triangles are left out.
pub(super) fn grid(records: &[CodedRecord], scales: &Scales) -> UnstructuredGrid {
    let triangles: Vec<Triangle> = records
        .iter()
        .filter_map(|record| match record.decode(scales) {
            Record::Triangle(triangle) => Some(triangle),
            _ => None,
        })
        .collect();
    let mut grid = UnstructuredGrid {
        points: Vec::with_capacity(3 * triangles.len()),
        cells: Cells::with_capacity(CellType::Triangle, triangles.len()),
        ..UnstructuredGrid::default()
    };
    for triangle in &triangles {
        let first = grid.points.len() as u32;
        grid.points.extend(triangle.corners.iter().map(|&[x, y]| [x, y, 0.0]));
        grid.cells.push(CellType::Triangle, &[first, first + 1, first + 2]);
    }
    let plane: Vec<PlaneStress> = triangles.iter().map(PlaneStress::of).collect();
    let vectors = |of: fn(&Triangle) -> [f64; 2]| triangles.iter().map(of).collect::<Vec<_>>();
    let scalars = |of: fn(&PlaneStress) -> f64| plane.iter().map(of).collect::<Vec<_>>();
    let principal = |of: fn(&PlaneStress) -> [f64; 2]| plane.iter().map(of).collect::<Vec<_>>();
    let stresses = triangles.iter().map(|t| [t.stress[0], t.stress[1], 0.0, t.stress[2], 0.0, 0.0]);
    grid.cell_data = vec![
        DataArray::plane_vector("velocity", &vectors(|t| t.velocity.get())),
        DataArray::symmetric_tensor("Cauchy stress", stresses.collect()),
        DataArray::scalar("mean stress (compression positive)", scalars(PlaneStress::mean)),
        DataArray::scalar("differential stress", scalars(PlaneStress::differential)),
        DataArray::scalar("sigma1 (compression positive)", scalars(|s| s.largest)),
        DataArray::scalar("sigma3 (compression positive)", scalars(|s| s.smallest)),
        DataArray::plane_vector(
            "sigma1 vector (compression positive)",
            &principal(PlaneStress::largest_vector),
        ),
        DataArray::plane_vector(
            "sigma3 vector (compression positive)",
            &principal(PlaneStress::smallest_vector),
        ),
        DataArray::plane_vector("contact force", &vectors(|t| t.contact_force.unwrap_or_default())),
        DataArray::scalar("damage", triangles.iter().map(|t| t.damage).collect()),
    ];
    grid
}

/// A stress in the plane, compression positive, and its principal values.
struct PlaneStress {
    xx: f64,
    yy: f64,
    xy: f64,
    largest: f64,
    smallest: f64,
}

impl PlaneStress {
    /// Operation for operation as the older converter computes it.
    fn of(triangle: &Triangle) -> Self {
        let [xx, yy, xy] = triangle.stress.map(|stress| -stress);
        let centre = 0.5 * (xx + yy);
        let half = 0.5 * (xx - yy);
        let radius = (half * half + xy * xy).sqrt();
        Self { xx, yy, xy, largest: centre + radius, smallest: centre - radius }
    }

    fn mean(&self) -> f64 {
        (self.largest + self.smallest) / 2.0
    }

    fn differential(&self) -> f64 {
        self.largest - self.smallest
    }

    /// The largest of the three principal stresses in its direction: zero if that is out of plane.
    fn largest_vector(&self) -> [f64; 2] {
        if self.largest > 0.0 { self.vector(self.largest, 0) } else { [0.0; 2] }
    }

    /// The smallest of the three.
    fn smallest_vector(&self) -> [f64; 2] {
        if self.smallest < 0.0 { self.vector(self.smallest, 1) } else { [0.0; 2] }
    }

    /// A principal stress times its direction. Where all directions are principal it is `axis`.
    fn vector(&self, value: f64, axis: usize) -> [f64; 2] {
        let (x, y) = if (value - self.xx).abs() > (value - self.yy).abs() {
            (self.xy, value - self.xx)
        } else {
            (value - self.yy, self.xy)
        };
        let length = x.hypot(y);
        if length > 0.0 {
            [value * x / length, value * y / length]
        } else {
            let mut vector = [0.0; 2];
            if let Some(component) = vector.get_mut(axis) {
                *component = value;
            }
            vector
        }
    }
}
