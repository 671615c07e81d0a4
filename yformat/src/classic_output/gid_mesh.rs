//! The mesh file for GiD.

use std::io::{self, Write};

use super::Table;
use super::text::E28;

/// Nodes and elements as the original writes them into `<base>.msh`, joints as degenerate triangles
/// included.
#[derive(Debug, Clone, Copy)]
pub struct GidMesh<'a> {
    /// Coordinates of all nodes, m.
    pub coordinates: &'a [[f64; 2]],
    /// Nodes of all elements, from 0.
    pub elements: &'a Table<i64>,
    /// How many of each row are written: `NELNO`, 3.
    pub nodes_per_element: usize,
}

impl GidMesh<'_> {
    /// Writes the file.
    ///
    /// # Errors
    /// If `out` cannot be written to.
    pub fn write_to(&self, mut out: impl Write) -> io::Result<()> {
        let per_element = self.nodes_per_element;
        writeln!(out, "MESH    dimension 2 ElemType Triangle  Nnode {per_element:4} ")?;
        writeln!(out, "Coordinates ")?;
        for (index, [x, y]) in self.coordinates.iter().enumerate() {
            writeln!(out, "{:5} {} {} ", index + 1, E28.format(*x), E28.format(*y))?;
        }
        writeln!(out, "End Coordinates ")?;
        writeln!(out, "Elements ")?;
        for (index, nodes) in self.elements.rows().enumerate() {
            write!(out, "{:5} ", index + 1)?;
            for node in nodes.iter().take(per_element) {
                write!(out, "{:10} ", node.saturating_add(1))?;
            }
            writeln!(out, "{:2}", 1)?;
        }
        writeln!(out, "End Elements ")
    }
}
