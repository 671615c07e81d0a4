//! From the connectivity of a d3plot file to cells.

use yformat::d3plot::{Geometry, Shell, Solid};

use crate::error::ConvertError;
use crate::vtk::CellType;

/// An element as a cell.
pub(super) struct Element {
    pub(super) kind: CellType,
    /// Points, from 0; as many count as the kind has.
    points: [u32; 8],
    /// Index in its section: the n-th solid or the n-th shell.
    pub(super) index: usize,
    /// Whether the section is that of the solids.
    pub(super) solid: bool,
    /// Material of the file, from 1.
    pub(super) material: i32,
}

impl Element {
    /// The points of the cell.
    pub(super) fn points(&self) -> &[u32] {
        let (points, _) = self.points.split_at(self.kind.points());
        points
    }
}

/// Elements that go into one grid.
pub(super) type Block = Vec<Element>;

/// Sorts the elements of a file into continuum elements and joints, as cells.
///
/// Joints are the wedges among the solids and the shells that are no triangles.
pub(super) fn split(geometry: &Geometry) -> Result<[Block; 2], ConvertError> {
    let nodes = geometry.coordinates.len();
    let mut continuum = Block::new();
    let mut joints = Block::new();
    for (index, solid) in geometry.solids.iter().enumerate() {
        let (kind, numbers) = solid_cell(solid);
        let element = element(index, true, kind, &numbers, solid.material, nodes)?;
        match kind {
            CellType::Wedge => joints.push(element),
            _ => continuum.push(element),
        }
    }
    for (index, shell) in geometry.shells.iter().enumerate() {
        let (kind, numbers) = shell_cell(shell);
        let element = element(index, false, kind, &numbers, shell.material, nodes)?;
        match kind {
            CellType::Quad => joints.push(element),
            _ => continuum.push(element),
        }
    }
    Ok([continuum, joints])
}

fn solid_cell(solid: &Solid) -> (CellType, [i32; 8]) {
    let n = solid.nodes;
    if solid.is_tetrahedron() {
        (CellType::Tetra, n)
    } else if solid.is_wedge() {
        // n0 n1 n4 on one side, n3 n2 n6 on the other.
        let wedge = [n[0], n[1], n[4], n[3], n[2], n[6], n[6], n[6]];
        (CellType::Wedge, wedge)
    } else {
        (CellType::Hexahedron, n)
    }
}

fn shell_cell(shell: &Shell) -> (CellType, [i32; 8]) {
    let [a, b, c, d] = shell.nodes;
    let kind = if shell.is_triangle() { CellType::Triangle } else { CellType::Quad };
    (kind, [a, b, c, d, d, d, d, d])
}

fn element(
    index: usize,
    solid: bool,
    kind: CellType,
    numbers: &[i32; 8],
    material: i32,
    nodes: usize,
) -> Result<Element, ConvertError> {
    let mut points = [0; 8];
    for (point, &number) in points.iter_mut().zip(numbers) {
        *point = u32::try_from(i64::from(number) - 1)
            .ok()
            .filter(|&point| (point as usize) < nodes)
            .ok_or(ConvertError::NoSuchNode { element: index + 1, node: number, nodes })?;
    }
    Ok(Element { kind, points, index, solid, material })
}
