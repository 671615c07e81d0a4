//! Full-precision state files, as the original's reference states have them.

use std::{fs, io, path::Path};

/// State in the plane: x y vx vy fx fy mass of each node.
pub type StateFile = States<7>;
/// State in space: x y z vx vy vz fx fy fz mass of each node.
pub type SpatialStateFile = States<10>;

/// Node and element lines of a state file.
#[derive(Debug, Clone)]
pub struct States<const N: usize> {
    /// Coordinates, velocity, force and mass of each node.
    pub nodes: Vec<[f64; N]>,
    /// Boundary flag and set of each node.
    pub flags: Vec<[i64; 2]>,
    /// Number, property and nodes of each element.
    pub elements: Vec<Vec<i64>>,
}

impl<const N: usize> PartialEq for States<N> {
    /// Equal to the last bit, the sign of zeros included.
    fn eq(&self, other: &Self) -> bool {
        let bits = |s: &Self| -> Vec<[u64; N]> {
            s.nodes.iter().map(|row| row.map(f64::to_bits)).collect()
        };
        bits(self) == bits(other) && self.flags == other.flags && self.elements == other.elements
    }
}

impl<const N: usize> States<N> {
    /// Reads a file.
    pub fn read(path: &Path) -> io::Result<Self> {
        let bad = |line: &str| {
            let message = format!("{}: cannot read `{line}`", path.display());
            io::Error::new(io::ErrorKind::InvalidData, message)
        };
        let mut state = Self { nodes: Vec::new(), flags: Vec::new(), elements: Vec::new() };
        let mut in_elements = false;
        for line in fs::read_to_string(path)?.lines() {
            if line.starts_with('#') {
                in_elements |= line.starts_with("# element");
            } else if in_elements {
                let words: Result<Vec<i64>, _> = line.split_whitespace().map(str::parse).collect();
                state.elements.push(words.map_err(|_| bad(line))?);
            } else {
                let words: Vec<&str> = line.split_whitespace().collect();
                let [_, numbers @ .., flag, set] = words.as_slice() else { return Err(bad(line)) };
                let numbers: Result<Vec<f64>, _> = numbers.iter().map(|w| w.parse()).collect();
                let row = numbers.ok().and_then(|n| n.try_into().ok()).ok_or_else(|| bad(line))?;
                state.nodes.push(row);
                let integer = |w: &str| w.parse().map_err(|_| bad(line));
                state.flags.push([integer(flag)?, integer(set)?]);
            }
        }
        Ok(state)
    }
}

/// Largest differences relative to the largest value of the quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Differences {
    /// Coordinates.
    pub coordinates: f64,
    /// Velocities.
    pub velocities: f64,
    /// Forces.
    pub forces: f64,
    /// Masses.
    pub masses: f64,
    /// Whether counts, flags, properties and topology agree.
    pub structure_agrees: bool,
}

impl Differences {
    /// Whether coordinates and masses agree to `positions`, velocities and
    /// forces to `rates`.
    pub fn within(&self, positions: f64, rates: f64) -> bool {
        self.structure_agrees
            && self.coordinates <= positions
            && self.masses <= positions
            && self.velocities <= rates
            && self.forces <= rates
    }
}

/// Compares two states.
pub fn compare<const N: usize>(reference: &States<N>, candidate: &States<N>) -> Differences {
    let dimension = (N - 1) / 3;
    let worst = |columns: std::ops::Range<usize>| {
        let values = |s: &States<N>| -> Vec<f64> {
            s.nodes.iter().flat_map(|row| row[columns.clone()].to_vec()).collect()
        };
        let (a, b) = (values(reference), values(candidate));
        let scale = a.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let scale = if scale > 0.0 { scale } else { 1.0 };
        // a NaN on either side counts as infinitely far
        let far = |(x, y): (&f64, &f64)| {
            let d = (x - y).abs() / scale;
            if d.is_nan() { f64::INFINITY } else { d }
        };
        a.iter().zip(&b).map(far).fold(0.0, f64::max)
    };
    Differences {
        coordinates: worst(0..dimension),
        velocities: worst(dimension..2 * dimension),
        forces: worst(2 * dimension..3 * dimension),
        masses: worst(3 * dimension..N),
        structure_agrees: reference.nodes.len() == candidate.nodes.len()
            && reference.flags == candidate.flags
            && reference.elements == candidate.elements,
    }
}
