//! Files of the Visualization Toolkit: `.vtu` unstructured grids and `.pvd` collections.
//!
//! The XML is written with `quick-xml` and the arrays as raw appended data, the fastest form
//! to write and to read. The crate `vtkio` (0.7.0-rc2) was considered and cannot do this: on
//! writing it puts arrays inline in base64, builds the whole file in memory, and has no
//! component names.
//!
//! ```
//! use ypsilon_converters::vtk::{self, CellType, DataArray, PvdSeries, UnstructuredGrid};
//!
//! # let folder = std::env::temp_dir().join(format!("vtk-doc-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! let mut grid = UnstructuredGrid {
//!     points: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     ..UnstructuredGrid::default()
//! };
//! grid.cells.push(CellType::Triangle, &[0, 1, 2]);
//! grid.cell_data.push(DataArray::symmetric_tensor("stress", vec![[1.0, 2.0, 0.0, 0.5, 0.0, 0.0]]));
//! grid.field_data.push(DataArray::time(0.25));
//! vtk::write_vtu(&folder.join("wall_0.vtu"), &grid)?;
//!
//! let mut series = PvdSeries::new();
//! series.push(0.25, 0, "triangles", "wall_0.vtu");
//! series.write(&folder.join("wall.pvd"))?;
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cells;
mod data_array;
mod grid;
mod pvd;
mod read;
mod vtu;

pub use cells::{CellType, Cells};
pub use data_array::{Components, DataArray, Values};
pub use grid::UnstructuredGrid;
pub use pvd::PvdSeries;
pub use read::{PvdEntry, decode_pvd, decode_vtu, read_pvd, read_vtu};
pub use vtu::{encode_vtu, write_vtu};
