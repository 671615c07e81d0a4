//! Fractures and model boundaries as lines.

use yformat::ym::{BoundaryJoint, CodedRecord, FractureJoint, Record, RecordKind, Scales};

use crate::vtk::{CellType, DataArray, UnstructuredGrid};

/// Where the coded dilation stands among the reals of a fracture.
const DILATION: usize = 14;
/// What the older converter takes for the scale of shear displacements.
const LEGACY_SCALE: f64 = 0.05;

/// One line with what belongs to it.
struct Line<'a> {
    ends: [[f64; 2]; 2],
    joint: Joint<'a>,
}

#[derive(Clone, Copy)]
enum Joint<'a> {
    Fracture { joint: &'a FractureJoint, legacy_shear: f64 },
    Boundary(&'a BoundaryJoint),
}

/// The grid that shows these records: first both walls of all fractures, then the boundaries.
pub(super) fn grid(records: &[CodedRecord], scales: &Scales) -> UnstructuredGrid {
    let decoded: Vec<(f64, Record)> = records
        .iter()
        .map(|record| {
            let dilation = match record.kind() {
                RecordKind::FractureJoint => record.unit(DILATION).unwrap_or_default(),
                _ => 0.0,
            };
            ((dilation * LEGACY_SCALE).abs(), record.decode(scales))
        })
        .collect();
    let mut lines = Vec::with_capacity(2 * records.len());
    for (legacy_shear, record) in &decoded {
        if let Record::FractureJoint(joint) = record {
            let [a, b, c, d] = joint.nodes;
            let joint = Joint::Fracture { joint, legacy_shear: *legacy_shear };
            lines.extend([[a, b], [c, d]].map(|ends| Line { ends, joint }));
        }
    }
    for (_, record) in &decoded {
        if let Record::BoundaryJoint(joint) = record {
            let [a, b, ..] = joint.nodes;
            lines.push(Line { ends: [a, b], joint: Joint::Boundary(joint) });
        }
    }
    let mut grid = UnstructuredGrid::default();
    for line in &lines {
        let first = grid.points.len() as u32;
        grid.points.extend(line.ends.iter().map(|&[x, y]| [x, y, 0.0]));
        grid.cells.push(CellType::Line, &[first, first + 1]);
    }
    grid.cell_data = arrays(&lines);
    grid
}

fn arrays(lines: &[Line<'_>]) -> Vec<DataArray> {
    let scalar = |name: &str, boundary: f64, fracture: fn(&FractureJoint) -> f64| {
        let value = |line: &Line<'_>| match line.joint {
            Joint::Fracture { joint, .. } => fracture(joint),
            Joint::Boundary(_) => boundary,
        };
        DataArray::scalar(name, lines.iter().map(value).collect())
    };
    let legacy = lines.iter().map(|line| match line.joint {
        Joint::Fracture { legacy_shear, .. } => legacy_shear,
        Joint::Boundary(_) => 0.0,
    });
    let kinds = lines.iter().map(|line| match line.joint {
        Joint::Fracture { joint, .. } => i32::from(joint.failure_mode >= 0.5),
        Joint::Boundary(_) => -1,
    });
    let forces: Vec<[f64; 2]> = lines
        .iter()
        .map(|line| match line.joint {
            Joint::Fracture { .. } => [0.0; 2],
            Joint::Boundary(joint) => joint.contact_force,
        })
        .collect();
    vec![
        DataArray::integer("fracture type", kinds.collect()),
        scalar("failure mode", -1.0, |joint| joint.failure_mode),
        scalar("shear displacement", 0.0, |joint| joint.shear_displacement),
        scalar("dilation", 0.0, |joint| joint.dilation),
        scalar("aperture", 0.0, |joint| joint.aperture),
        scalar("hydraulic aperture", 0.0, |joint| joint.hydraulic_aperture),
        scalar("normal stress (compression positive)", 0.0, |joint| joint.normal_stress),
        scalar("shear stress", 0.0, |joint| joint.shear_stress),
        scalar("sliding force", 0.0, |joint| joint.sliding_force),
        DataArray::plane_vector("contact force", &forces),
        DataArray::scalar("legacy shear displacement", legacy.collect()),
    ]
}
