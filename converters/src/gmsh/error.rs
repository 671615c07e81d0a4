//! Why a mesh makes no deck.

/// Why a `.msh` file cannot be read or converted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum GmshError {
    /// The file does not begin as `.msh` files do.
    #[error("line 1: this is no Gmsh mesh; expected $MeshFormat")]
    NoMesh,
    /// A version of the format that is not read.
    #[error(
        "line {line}: format version `{version}` is not read; expected 2.2 or 4.1. In Gmsh: \
         File > Export > `.msh`, or `gmsh -2 -format msh41 ...`"
    )]
    Version {
        /// Line, from 1.
        line: usize,
        /// What the file says.
        version: String,
    },
    /// The file is in Gmsh's binary form.
    #[error(
        "line {line}: this is a binary mesh; expected a text one. Save it without `Mesh.Binary` \
         (`gmsh -2 -setnumber Mesh.Binary 0 ...`)"
    )]
    Binary {
        /// Line, from 1.
        line: usize,
    },
    /// A word is not what the format asks for.
    #[error("line {line}: found {found} where {expected} is expected")]
    Unexpected {
        /// Line, from 1.
        line: usize,
        /// The offending word, in back quotes, or `the end of the file`.
        found: String,
        /// What the format asks for.
        expected: &'static str,
    },
    /// An element of a kind that makes no triangles of a plane mesh.
    #[error("line {line}: element type {number} ({kind}); {remedy}")]
    ElementType {
        /// Line, from 1.
        line: usize,
        /// Gmsh's number of the type.
        number: i64,
        /// What it is.
        kind: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A section that every mesh has is missing.
    #[error("the file has no ${0} section; is it complete?")]
    NoSection(&'static str),
    /// A node number that occurs twice.
    #[error("node {0} is given twice")]
    NodeTwice(i64),
    /// An element names a node that does not exist.
    #[error("element {element} names node {node}, which the file does not give")]
    NoSuchNode {
        /// Element number of the file.
        element: i64,
        /// The node it names.
        node: i64,
    },
    /// The mesh has no triangles or quadrangles.
    #[error(
        "the mesh has no triangles; mesh the surfaces (`gmsh -2 ...`) and, where physical groups \
         are used, put the surfaces into some: Gmsh saves only elements of groups"
    )]
    NoTriangles,
    /// The mesh does not lie in the plane.
    #[error("node {node} has z = {z}, others z = {plane}; expected a mesh in the plane of x and y")]
    NotPlane {
        /// Node number of the file.
        node: i64,
        /// Its z, as text.
        z: String,
        /// z of the first node, as text.
        plane: String,
    },
    /// A triangle without area.
    #[error("element {0} has no area; mend the mesh (`gmsh -check`)")]
    NoArea(i64),
}
