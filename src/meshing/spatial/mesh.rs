//! Tetrahedra made from boxes, from one cube around its centre, and from triangles that are drawn
//! out across the depth.

use crate::meshing::{MeshingError, mesh::Mesh, properties::check_elements};
use std::{collections::BTreeMap, ops::Range};

/// A place in space: along, across, up \[m\].
pub type Place = [f64; 3];

/// A tetrahedron of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Tetrahedron {
    /// Its nodes; the last one is on the side to which the first three run counter-clockwise.
    pub nodes: [usize; 4],
    /// The block that it belongs to.
    pub block: usize,
    /// What it is made of: an index into the model's materials.
    pub material: usize,
}

impl Tetrahedron {
    /// Its faces, seen from outside counter-clockwise.
    #[must_use]
    pub fn faces(&self) -> [[usize; 3]; 4] {
        let [a, b, c, d] = self.nodes;
        [[a, c, b], [a, b, d], [b, c, d], [c, a, d]]
    }
}

/// Nodes and tetrahedra; neighbours share nodes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SpatialMesh {
    /// Places of the nodes \[m\].
    pub nodes: Vec<Place>,
    /// The tetrahedra.
    pub tetrahedra: Vec<Tetrahedron>,
    /// Number of blocks.
    pub blocks: usize,
}

/// The six tetrahedra of a cell around the diagonal from its first to its last corner; corner
/// `i` lies at bit 0 of `i` along, bit 1 across and bit 2 up.
const CELL: [[usize; 4]; 6] =
    [[0, 1, 3, 7], [0, 5, 1, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 6, 4, 7]];

/// The twelve outer triangles of a cube, each face cut by one diagonal, seen from inside
/// counter-clockwise.
const SHELL: [[usize; 3]; 12] = [
    [0, 1, 3],
    [0, 3, 2],
    [4, 7, 5],
    [4, 6, 7],
    [0, 5, 1],
    [0, 4, 5],
    [2, 3, 7],
    [2, 7, 6],
    [0, 2, 6],
    [0, 6, 4],
    [1, 7, 3],
    [1, 5, 7],
];

/// Sum of products.
pub(super) fn dot(a: Place, b: Place) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
pub(super) fn cross(a: Place, b: Place) -> Place {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// What leads from `a` to `b`.
pub(super) fn difference(a: Place, b: Place) -> Place {
    [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
}

impl SpatialMesh {
    /// Places of a tetrahedron's corners.
    #[must_use]
    pub fn corners(&self, tetrahedron: &Tetrahedron) -> [Place; 4] {
        tetrahedron.nodes.map(|node| self.nodes[node])
    }

    /// Volume of a tetrahedron, negative if it is inside out \[m³\].
    #[must_use]
    pub fn volume(&self, tetrahedron: &Tetrahedron) -> f64 {
        let [a, b, c, d] = self.corners(tetrahedron);
        dot(cross(difference(a, b), difference(a, c)), difference(a, d)) / 6.0
    }

    /// The shortest height of a tetrahedron \[m\]: three times its volume by its largest face.
    #[must_use]
    pub fn height(&self, tetrahedron: &Tetrahedron) -> f64 {
        let largest = tetrahedron.faces().map(|face| self.face_area(face)).into_iter();
        3.0 * self.volume(tetrahedron) / largest.fold(0.0, f64::max)
    }

    /// Area of a face \[m²\].
    #[must_use]
    pub fn face_area(&self, face: [usize; 3]) -> f64 {
        let [a, b, c] = face.map(|node| self.nodes[node]);
        let normal = cross(difference(a, b), difference(a, c));
        0.5 * dot(normal, normal).sqrt()
    }

    /// Volume of all tetrahedra \[m³\].
    #[must_use]
    pub fn total_volume(&self) -> f64 {
        self.tetrahedra.iter().map(|t| self.volume(t)).sum()
    }

    /// The tetrahedra at each face, by its nodes in ascending order.
    #[must_use]
    pub fn faces(&self) -> BTreeMap<[usize; 3], Vec<usize>> {
        let mut found: BTreeMap<[usize; 3], Vec<usize>> = BTreeMap::new();
        for (index, tetrahedron) in self.tetrahedra.iter().enumerate() {
            for mut face in tetrahedron.faces() {
                face.sort_unstable();
                found.entry(face).or_default().push(index);
            }
        }
        found
    }

    /// Adds a body of its own: a box of cells with six tetrahedra each. Neighbouring cells cut
    /// the face between them by the same diagonal. Returns its nodes.
    ///
    /// # Errors
    /// If the mesh would become too large.
    pub fn add_box(
        &mut self,
        [low, high]: [Place; 2],
        cells: [usize; 3],
        material: usize,
    ) -> Result<Range<usize>, MeshingError> {
        let [nx, ny, nz] = cells;
        check_elements(self.tetrahedra.len(), &[6, nx, ny, nz])?;
        let first = self.nodes.len();
        let side = cells.map(|n| n + 1);
        let at = |k: usize, i: usize| {
            // the last one exactly, so that faces lie where they should
            if i == cells[k] {
                high[k]
            } else {
                low[k] + (high[k] - low[k]) * (i as f64 / cells[k] as f64)
            }
        };
        for z in 0..side[2] {
            for y in 0..side[1] {
                self.nodes.extend((0..side[0]).map(|x| [at(0, x), at(1, y), at(2, z)]));
            }
        }
        let node = |x: usize, y: usize, z: usize| first + x + side[0] * (y + side[1] * z);
        for z in 0..cells[2] {
            for y in 0..cells[1] {
                for x in 0..cells[0] {
                    let corner = |i: usize| node(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
                    self.add_cell(corner, self.blocks, material);
                }
            }
        }
        self.blocks += 1;
        Ok(first..self.nodes.len())
    }

    /// Adds the tetrahedra of a cell whose eight corners are there.
    pub(super) fn add_cell(
        &mut self,
        corner: impl Fn(usize) -> usize,
        block: usize,
        material: usize,
    ) {
        let cell = CELL.map(|t| Tetrahedron { nodes: t.map(&corner), block, material });
        self.tetrahedra.extend(cell);
    }

    /// Adds a body of its own: a box of twelve tetrahedra, eight corners and a centre. Returns
    /// its nodes, the centre last.
    pub fn add_centred_box(&mut self, [low, high]: [Place; 2], material: usize) -> Range<usize> {
        let first = self.nodes.len();
        let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 0 { low[k] } else { high[k] });
        self.nodes.extend((0..8).map(corner));
        self.nodes.push([0, 1, 2].map(|k| f64::midpoint(low[k], high[k])));
        let block = self.blocks;
        self.tetrahedra.extend(SHELL.map(|[a, b, c]| Tetrahedron {
            nodes: [first + a, first + b, first + c, first + 8],
            block,
            material,
        }));
        self.blocks += 1;
        first..first + 9
    }

    /// Draws out a mesh of triangles in the plane along and up across `depth`, in layers of three
    /// tetrahedra for each triangle. Node `n` of the plane is node `layer · nodes + n`. `block`
    /// says which block a triangle belongs to in a layer.
    ///
    /// # Errors
    /// If the mesh would be too large.
    pub fn drawn_out(
        plane: &Mesh,
        depth: f64,
        layers: usize,
        block: impl Fn(&crate::meshing::Triangle, usize) -> usize,
    ) -> Result<Self, MeshingError> {
        check_elements(0, &[3, plane.triangles.len(), layers])?;
        let count = plane.nodes.len();
        let mut mesh = SpatialMesh::default();
        for layer in 0..=layers {
            let y = depth * (layer as f64 / layers as f64);
            mesh.nodes.extend(plane.nodes.iter().map(|&[x, z]| [x, y, z]));
        }
        for layer in 0..layers {
            for triangle in &plane.triangles {
                // diagonals run from the lower number in front to the higher one behind, which
                // neighbours agree on
                let mut front = triangle.nodes;
                front.sort_unstable();
                let [a, b, c] = front.map(|node| node + layer * count);
                let [d, e, f] = front.map(|node| node + (layer + 1) * count);
                let block = block(triangle, layer);
                for nodes in [[a, b, c, f], [a, b, e, f], [a, d, e, f]] {
                    let mut own = Tetrahedron { nodes, block, material: triangle.material };
                    if mesh.volume(&own) < 0.0 {
                        own.nodes.swap(0, 1);
                    }
                    mesh.tetrahedra.push(own);
                }
            }
        }
        mesh.blocks = mesh.tetrahedra.iter().map(|t| t.block + 1).max().unwrap_or(0);
        Ok(mesh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Inner faces lie between two tetrahedra, and the volume is that of the outline: nothing
    /// overlaps, nothing is left out.
    fn fills(mesh: &SpatialMesh, volume: f64, surface: f64) {
        assert!(mesh.tetrahedra.iter().all(|t| mesh.volume(t) > 0.0));
        assert!((mesh.total_volume() / volume - 1.0).abs() < 1e-13);
        let faces = mesh.faces();
        assert!(faces.values().all(|sides| sides.len() <= 2));
        let outer = faces.iter().filter(|(_, sides)| sides.len() == 1);
        let area: f64 = outer.map(|(&face, _)| mesh.face_area(face)).sum();
        assert!((area / surface - 1.0).abs() < 1e-13, "{area} {surface}");
    }

    proptest! {
        #[test]
        fn boxes_are_filled(
            size in [0.1..3.0, 0.1..3.0, 0.1..3.0],
            cells in [1_usize..4, 1_usize..4, 1_usize..4],
        ) {
            let [a, b, c]: [f64; 3] = size;
            let high = [a - 1.0, b, c + 0.5];
            let (volume, surface) = (a * b * c, 2.0 * (a * b + b * c + c * a));
            let mut mesh = SpatialMesh::default();
            mesh.add_box([[-1.0, 0.0, 0.5], high], cells, 0).expect("a small box");
            fills(&mesh, volume, surface);
            prop_assert_eq!(mesh.tetrahedra.len(), 6 * cells.iter().product::<usize>());
            let mut mesh = SpatialMesh::default();
            mesh.add_centred_box([[-1.0, 0.0, 0.5], high], 0);
            fills(&mesh, volume, surface);
            prop_assert_eq!(mesh.tetrahedra.len(), 12);
        }
    }

    #[test]
    fn drawn_out_triangles_fill_their_prism() {
        let mut plane = Mesh::default();
        plane.rectangle([[0.0, 0.0], [3.0, 2.0]], [3, 2], 0).expect("a small mesh");
        let mesh = SpatialMesh::drawn_out(&plane, 1.5, 2, |t, _| t.block).expect("a small mesh");
        assert_eq!(mesh.tetrahedra.len(), 3 * 2 * plane.triangles.len());
        fills(&mesh, 9.0, 2.0 * (6.0 + 4.5 + 3.0));
    }
}
