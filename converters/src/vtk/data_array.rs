//! Named arrays of a grid.

/// The numbers of an array, all components of the first entry first.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Double precision.
    Float64(Vec<f64>),
    /// Single precision.
    Float32(Vec<f32>),
    /// 64-bit integers.
    Int64(Vec<i64>),
    /// 32-bit integers.
    Int32(Vec<i32>),
    /// Bytes.
    UInt8(Vec<u8>),
}

impl Values {
    /// How many numbers there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Float64(values) => values.len(),
            Self::Float32(values) => values.len(),
            Self::Int64(values) => values.len(),
            Self::Int32(values) => values.len(),
            Self::UInt8(values) => values.len(),
        }
    }

    /// Whether there are no numbers.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// What the components of an array's entries are.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Components {
    /// One number.
    Scalar,
    /// X, Y, Z.
    Vector,
    /// XX, YY, ZZ, XY, YZ, XZ: the order ParaView understands as a symmetric tensor.
    SymmetricTensor,
    /// Others, by name.
    Named(Vec<String>),
}

impl Components {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector => 3,
            Self::SymmetricTensor => 6,
            Self::Named(names) => names.len(),
        }
    }

    /// Their names, none for a scalar.
    pub fn names(&self) -> Vec<&str> {
        match self {
            Self::Scalar => Vec::new(),
            Self::Vector => vec!["X", "Y", "Z"],
            Self::SymmetricTensor => vec!["XX", "YY", "ZZ", "XY", "YZ", "XZ"],
            Self::Named(names) => names.iter().map(String::as_str).collect(),
        }
    }
}

/// A named array: point data, cell data or field data.
#[derive(Debug, Clone, PartialEq)]
pub struct DataArray {
    /// Name, as users see it.
    pub name: String,
    /// What an entry consists of.
    pub components: Components,
    /// The numbers.
    pub values: Values,
}

impl DataArray {
    /// One double per entry.
    pub fn scalar(name: impl Into<String>, values: Vec<f64>) -> Self {
        Self::new(name, Components::Scalar, Values::Float64(values))
    }

    /// One integer per entry.
    pub fn integer(name: impl Into<String>, values: Vec<i32>) -> Self {
        Self::new(name, Components::Scalar, Values::Int32(values))
    }

    /// One byte per entry.
    pub fn byte(name: impl Into<String>, values: Vec<u8>) -> Self {
        Self::new(name, Components::Scalar, Values::UInt8(values))
    }

    /// A vector per entry.
    pub fn vector(name: impl Into<String>, values: Vec<[f64; 3]>) -> Self {
        let values = Values::Float64(values.into_flattened());
        Self::new(name, Components::Vector, values)
    }

    /// A vector in the plane per entry; the third component is 0.
    pub fn plane_vector(name: impl Into<String>, values: &[[f64; 2]]) -> Self {
        Self::vector(name, values.iter().map(|&[x, y]| [x, y, 0.0]).collect())
    }

    /// A symmetric tensor per entry: xx, yy, zz, xy, yz, xz.
    pub fn symmetric_tensor(name: impl Into<String>, values: Vec<[f64; 6]>) -> Self {
        let values = Values::Float64(values.into_flattened());
        Self::new(name, Components::SymmetricTensor, values)
    }

    /// The field array that tells VTK readers the time of a file.
    pub fn time(time: f64) -> Self {
        Self::scalar("TimeValue", vec![time])
    }

    /// An array of any kind.
    pub fn new(name: impl Into<String>, components: Components, values: Values) -> Self {
        Self { name: name.into(), components, values }
    }

    /// How many whole entries there are.
    pub fn entries(&self) -> usize {
        self.values.len() / self.components.count().max(1)
    }
}
