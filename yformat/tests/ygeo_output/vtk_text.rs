//! Reads the arrays out of Y-Geo's VTK XML.

use std::collections::BTreeMap;

/// The numbers of a file by the names of their arrays; the points are called `Points`.
pub struct VtkText {
    arrays: BTreeMap<String, Vec<f64>>,
}

impl VtkText {
    pub fn parse(text: &str) -> Self {
        let lines: Vec<&str> = text.split('\n').collect();
        let mut arrays = BTreeMap::new();
        for (index, line) in lines.iter().enumerate() {
            if let Some(name) = array_name(line) {
                let numbers = lines[index + 1].split_whitespace();
                arrays.insert(name, numbers.map(|number| number.parse().unwrap()).collect());
            }
        }
        Self { arrays }
    }

    pub fn get(&self, name: &str) -> &[f64] {
        self.arrays.get(name).unwrap_or_else(|| panic!("no array {name}"))
    }

    /// The first two of every three numbers.
    pub fn plane_vectors(&self, name: &str) -> Vec<[f64; 2]> {
        self.get(name).chunks_exact(3).map(|vector| [vector[0], vector[1]]).collect()
    }

    /// The components of the plane of every nine numbers.
    pub fn tensors(&self, name: &str) -> Vec<[[f64; 2]; 2]> {
        self.get(name).chunks_exact(9).map(|t| [[t[0], t[1]], [t[3], t[4]]]).collect()
    }
}

/// The array that begins with this line.
pub fn array_name(line: &str) -> Option<String> {
    // The arrays without data in the principal directions end in the same line.
    if !line.starts_with("<DataArray") || line.ends_with("/>") {
        return None;
    }
    let name = line.split_once("Name='").and_then(|(_, rest)| rest.split_once('\''));
    Some(name.map_or("Points", |(name, _)| name).to_owned())
}
