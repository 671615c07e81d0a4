use thiserror::Error;

/// Why a mesh cannot be made.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum MeshingError {
    /// A parameter without sense.
    #[error("{name} = {value}: {expected}")]
    Parameter {
        /// The parameter, as in a scenario file.
        name: String,
        /// What it is.
        value: String,
        /// What it has to be.
        expected: String,
    },
    /// A file that cannot be read.
    #[error("cannot read {path}: {source}")]
    Io {
        /// The file.
        path: std::path::PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// A scenario file with mistakes.
    #[error("{0}")]
    Scenario(String),
    /// More elements than anybody can simulate.
    #[error(
        "the mesh would have {elements:.1e} elements, at most {most:.0e} are possible: choose fewer cells, \
         courses or blocks"
    )]
    TooLarge {
        /// How many there would be.
        elements: f64,
        /// How many there may be.
        most: f64,
    },
    /// A block that was turned inside out.
    #[error(
        "the block at ({x:.3}, {y:.3}) has the area {area:.3e} m²: choose other numbers of courses \
         or voussoirs, or a smaller `smallest_m`"
    )]
    FlatBlock {
        /// Abscissa of its middle \[m\].
        x: f64,
        /// Ordinate of its middle \[m\].
        y: f64,
        /// Its area \[m²\].
        area: f64,
    },
    /// A block that cannot be divided into triangles.
    #[error(
        "the block at ({x:.3}, {y:.3}) cannot be divided into triangles: choose other numbers of \
         courses or voussoirs"
    )]
    NoTriangles {
        /// Abscissa of its middle \[m\].
        x: f64,
        /// Ordinate of its middle \[m\].
        y: f64,
    },
    /// Blocks cover more or less than they should.
    #[error("the blocks cover {covered} m² instead of {expected} m²: {help}")]
    Cover {
        /// What they cover \[m²\].
        covered: f64,
        /// What they should cover \[m²\].
        expected: f64,
        /// What to do.
        help: &'static str,
    },
    /// Blocks overlap or do not share an edge as neighbours do.
    #[error(
        "two triangles lie on the same side of the edge from ({x0:.3}, {y0:.3}) to ({x1:.3}, {y1:.3})"
    )]
    Overlap {
        /// Abscissa of one end \[m\].
        x0: f64,
        /// Ordinate of one end \[m\].
        y0: f64,
        /// Abscissa of the other end \[m\].
        x1: f64,
        /// Ordinate of the other end \[m\].
        y1: f64,
    },
    /// A tetrahedron that was turned inside out.
    #[error("the tetrahedron at ({x:.3}, {y:.3}, {z:.3}) has the volume {volume:.3e} m³")]
    FlatTetrahedron {
        /// Place of its first node along \[m\].
        x: f64,
        /// Across \[m\].
        y: f64,
        /// Up \[m\].
        z: f64,
        /// Its volume \[m³\].
        volume: f64,
    },
    /// Tetrahedra that overlap.
    #[error("more than two tetrahedra share a face at ({x:.3}, {y:.3}, {z:.3})")]
    OverlapInSpace {
        /// Place of one of its nodes along \[m\].
        x: f64,
        /// Across \[m\].
        y: f64,
        /// Up \[m\].
        z: f64,
    },
    /// Tetrahedra fill more or less than they should.
    #[error("the tetrahedra fill {filled} m³ instead of {expected} m³")]
    Fill {
        /// What they fill \[m³\].
        filled: f64,
        /// What they should fill \[m³\].
        expected: f64,
    },
    /// Parts that hang together nowhere.
    #[error("the mesh falls into {parts} parts instead of {expected}")]
    Parts {
        /// Number of parts.
        parts: usize,
        /// What it should be.
        expected: usize,
    },
    /// Loads that do not add up.
    #[error(
        "at {time} s the nodes of the deck carry {found} N, but the loads amount to {expected} N"
    )]
    LoadSum {
        /// When \[s\].
        time: f64,
        /// Sum over the nodes \[N\].
        found: f64,
        /// What was asked for \[N\].
        expected: f64,
    },
}

impl MeshingError {
    /// A parameter without sense.
    pub(super) fn parameter(name: &str, value: impl ToString, expected: &str) -> Self {
        MeshingError::Parameter {
            name: name.to_owned(),
            value: value.to_string(),
            expected: expected.to_owned(),
        }
    }
}
