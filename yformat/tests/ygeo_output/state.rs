//! The states of the original to 17 digits (`state_N.txt`).

/// A node after the step; the force is that of the step.
pub struct Node {
    pub coordinates: [f64; 2],
    pub velocity: [f64; 2],
    pub force: [f64; 2],
    /// Zero in states before the first step and for the deck's nodes after meshing.
    pub mass: f64,
}

pub struct Triangle {
    pub property: usize,
    pub nodes: [usize; 3],
}

pub struct Joint {
    pub element: usize,
    pub property: i64,
    pub nodes: [usize; 4],
    pub at_boundary: bool,
}

#[derive(Default)]
pub struct State {
    pub nodes: Vec<Node>,
    pub triangles: Vec<Triangle>,
    pub joints: Vec<Joint>,
}

impl State {
    pub fn parse(text: &str) -> Self {
        let mut state = Self::default();
        for line in text.lines() {
            let (kind, rest) = line.split_once(' ').unwrap_or((line, ""));
            let words: Vec<f64> = match kind {
                "N" | "T" | "J" => rest.split(' ').map(|word| word.parse().unwrap()).collect(),
                _ => continue,
            };
            let index = |column: usize| words[column] as usize;
            match kind {
                "N" => state.nodes.push(Node {
                    coordinates: [words[1], words[2]],
                    velocity: [words[3], words[4]],
                    force: [words[5], words[6]],
                    mass: words[7],
                }),
                "T" => state
                    .triangles
                    .push(Triangle { property: index(1), nodes: [index(2), index(3), index(4)] }),
                _ => state.joints.push(Joint {
                    element: index(0),
                    property: words[1] as i64,
                    nodes: [index(2), index(3), index(4), index(5)],
                    at_boundary: words[7] < 0.0,
                }),
            }
        }
        assert!(!state.nodes.is_empty() && !state.triangles.is_empty());
        state
    }
}
