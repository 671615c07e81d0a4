//! Masses, stiffness and viscosity of a scene at rest in its present shape.

use std::fmt;

use nalgebra::{DMatrix, SMatrix, SVector};

/// What a part of the system is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// A triangle or tetrahedron.
    Element(usize),
    /// A joint.
    Joint(usize),
    /// Two elements that touch.
    Contact([usize; 2]),
    /// An element with a free edge or face, pressed by one like it.
    Impact(usize),
}

/// Shares of the forces that count.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Weights {
    /// Of the elastic forces of elements.
    pub elastic: f64,
    /// Of the viscous forces of elements and of absorbing boundaries.
    pub viscous: f64,
    /// Of joints.
    pub joints: f64,
    /// Of contacts that are closed.
    pub contact: f64,
    /// Of contacts that may come.
    pub impact: f64,
}

impl Weights {
    fn of(&self, part: Part) -> f64 {
        match part {
            Part::Element(_) => self.elastic,
            Part::Joint(_) => self.joints,
            Part::Contact(_) => self.contact,
            Part::Impact(_) => self.impact,
        }
    }
}

/// An element: symmetric matrices over its nodes, the upper triangle row by row.
#[derive(Debug, Clone)]
struct Block {
    element: u32,
    /// Where its nodes begin, and how many there are.
    nodes: (u32, u32),
    /// Where its stiffness begins; its viscosity comes behind it, if it has one.
    values: usize,
    is_viscous: bool,
}

/// A spring between two points of bodies, each a weighted mean of nodes.
#[derive(Debug, Clone)]
struct Tie<const D: usize> {
    part: Part,
    /// Where its nodes begin, and how many there are.
    nodes: (u32, u32),
    normal: SVector<f64, D>,
    /// Stiffness along the normal and across it, N/m.
    stiffness: [f64; 2],
}

/// A scene as small vibrations see it.
#[derive(Debug, Clone)]
pub struct System<const D: usize> {
    /// Nodal masses, kg; 0 where a node does not move.
    pub mass: Vec<f64>,
    /// Projector on the directions in which a node moves, where these are not all.
    pub free: Vec<Option<SMatrix<f64, D, D>>>,
    blocks: Vec<Block>,
    block_nodes: Vec<u32>,
    // single precision: seven digits are more than a bound needs, and large meshes have many
    values: Vec<f32>,
    ties: Vec<Tie<D>>,
    tie_nodes: Vec<(u32, f64)>,
    /// Viscous resistance of nodes along the axes, N s/m.
    dashpots: Vec<(u32, SVector<f64, D>)>,
}

impl<const D: usize> System<D> {
    /// A system of so many nodes without mass.
    #[must_use]
    pub fn new(nodes: usize) -> Self {
        Self {
            mass: vec![0.0; nodes],
            free: vec![None; nodes],
            blocks: Vec::new(),
            block_nodes: Vec::new(),
            values: Vec::new(),
            ties: Vec::new(),
            tie_nodes: Vec::new(),
            dashpots: Vec::new(),
        }
    }

    /// Adds an element with its stiffness, N/m, and viscosity, N s/m.
    pub fn add_element(&mut self, element: usize, nodes: &[usize], matrices: &ElementMatrices) {
        let first = self.block_nodes.len() as u32;
        self.block_nodes.extend(nodes.iter().map(|&n| n as u32));
        let values = self.values.len();
        let is_viscous = matrices.viscosity.iter().any(|&c| c != 0.0);
        let both = [Some(&matrices.stiffness), is_viscous.then_some(&matrices.viscosity)];
        for matrix in both.into_iter().flatten() {
            for row in 0..matrix.nrows() {
                self.values
                    .extend((row..matrix.ncols()).map(|column| matrix[(row, column)] as f32));
            }
        }
        let (element, nodes) = (element as u32, (first, nodes.len() as u32));
        self.blocks.push(Block { element, nodes, values, is_viscous });
    }

    /// Adds a spring between weighted means of nodes.
    pub fn add_tie(
        &mut self,
        part: Part,
        nodes: &[(usize, f64)],
        normal: SVector<f64, D>,
        stiffness: [f64; 2],
    ) {
        let first = self.tie_nodes.len() as u32;
        self.tie_nodes.extend(nodes.iter().map(|&(n, weight)| (n as u32, weight)));
        self.ties.push(Tie { part, nodes: (first, nodes.len() as u32), normal, stiffness });
    }

    /// Adds viscous resistance to a node, N s/m along each axis.
    pub fn add_dashpot(&mut self, node: usize, resistance: SVector<f64, D>) {
        self.dashpots.push((node as u32, resistance));
    }

    /// Whether anything moves.
    #[must_use]
    pub fn moves(&self) -> bool {
        self.mass.iter().any(|&m| m > 0.0)
    }

    /// Whether a weight brings in any force.
    #[must_use]
    pub fn has(&self, weights: &Weights) -> bool {
        (weights.elastic > 0.0 && !self.blocks.is_empty())
            || (weights.viscous > 0.0
                && (!self.dashpots.is_empty() || self.blocks.iter().any(|b| b.is_viscous)))
            || self.ties.iter().any(|tie| weights.of(tie.part) > 0.0)
    }

    /// Adds the weighted forces that displacements cause, signed along them.
    pub fn add_forces(&self, w: &Weights, u: &[SVector<f64, D>], f: &mut [SVector<f64, D>]) {
        let mut local = [0.0; MOST];
        let mut forces = [0.0; MOST];
        for block in &self.blocks {
            let nodes = self.nodes_of(block);
            let size = D * nodes.len();
            gather(nodes, u, &mut local);
            forces[..size].fill(0.0);
            let per = size * (size + 1) / 2;
            if w.elastic > 0.0 {
                add_product(&self.values[block.values..], size, w.elastic, &local, &mut forces);
            }
            if w.viscous > 0.0 && block.is_viscous {
                let values = &self.values[block.values + per..];
                add_product(values, size, w.viscous, &local, &mut forces);
            }
            for (i, &n) in nodes.iter().enumerate() {
                for k in 0..D {
                    f[n as usize][k] += forces[i * D + k];
                }
            }
        }
        for tie in &self.ties {
            let weight = w.of(tie.part);
            if weight > 0.0 {
                let force = tie.force(self.relative(tie, u)) * weight;
                for &(n, share) in self.ends_of(tie) {
                    f[n as usize] += force * share;
                }
            }
        }
        if w.viscous > 0.0 {
            for (n, resistance) in &self.dashpots {
                let n = *n as usize;
                f[n] += resistance.component_mul(&u[n]) * w.viscous;
            }
        }
    }

    /// Twice the weighted energy that each part has in a mode.
    #[must_use]
    pub fn energies(&self, w: &Weights, u: &[SVector<f64, D>]) -> Vec<(Share, f64)> {
        let mut energies = Vec::new();
        let mut local = [0.0; MOST];
        let mut forces = [0.0; MOST];
        for block in &self.blocks {
            let nodes = self.nodes_of(block);
            let size = D * nodes.len();
            gather(nodes, u, &mut local);
            let per = size * (size + 1) / 2;
            let mut energy = |from: usize, weight: f64| {
                forces[..size].fill(0.0);
                add_product(&self.values[from..], size, weight, &local, &mut forces);
                (0..size).map(|i| forces[i] * local[i]).sum::<f64>()
            };
            let part = Part::Element(block.element as usize);
            energies.push((Share::Stiffness(part), energy(block.values, w.elastic)));
            if block.is_viscous {
                energies.push((Share::Viscosity(part), energy(block.values + per, w.viscous)));
            }
        }
        for tie in &self.ties {
            let relative = self.relative(tie, u);
            let energy = w.of(tie.part) * tie.force(relative).dot(&relative);
            energies.push((Share::Stiffness(tie.part), energy));
        }
        energies
    }

    fn nodes_of(&self, block: &Block) -> &[u32] {
        let (first, count) = block.nodes;
        &self.block_nodes[first as usize..(first + count) as usize]
    }

    fn ends_of(&self, tie: &Tie<D>) -> &[(u32, f64)] {
        let (first, count) = tie.nodes;
        &self.tie_nodes[first as usize..(first + count) as usize]
    }

    fn relative(&self, tie: &Tie<D>, u: &[SVector<f64, D>]) -> SVector<f64, D> {
        self.ends_of(tie).iter().map(|&(n, weight)| u[n as usize] * weight).sum()
    }
}

/// What resists, and in which way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Share {
    /// By its stiffness.
    Stiffness(Part),
    /// By its viscosity.
    Viscosity(Part),
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Stiffness(part) => write!(f, "{part}"),
            Self::Viscosity(part) => write!(f, "the viscosity of {part}"),
        }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Element(e) => write!(f, "element {e}"),
            Self::Joint(e) => write!(f, "joint {e}"),
            Self::Contact([a, b]) => write!(f, "the contact of elements {a} and {b}"),
            Self::Impact(e) => write!(f, "contact with element {e}"),
        }
    }
}

/// Stiffness and viscosity of one element.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementMatrices {
    /// Stiffness, N/m.
    pub stiffness: DMatrix<f64>,
    /// Viscous resistance, N s/m.
    pub viscosity: DMatrix<f64>,
}

impl ElementMatrices {
    /// By differences of the forces that an element exerts at displacements from its present
    /// shape, m, and velocities, m/s. `size` is a length of the element.
    pub fn by_differences<const D: usize, const N: usize>(
        size: f64,
        forces: impl Fn(&[SVector<f64, D>; N], &[SVector<f64, D>; N]) -> [SVector<f64, D>; N],
    ) -> Self {
        let zero = [SVector::<f64, D>::zeros(); N];
        let one = |column: usize, by: f64| {
            let mut moved = zero;
            moved[column / D][column % D] = by;
            moved
        };
        let step = 1e-6 * size;
        let mut stiffness = DMatrix::zeros(N * D, N * D);
        let mut viscosity = DMatrix::zeros(N * D, N * D);
        let at_rest = forces(&zero, &zero);
        for column in 0..N * D {
            let ahead = forces(&one(column, step), &zero);
            let behind = forces(&one(column, -step), &zero);
            // viscous forces are proportional to velocity
            let moving = forces(&zero, &one(column, 1.0));
            for row in 0..N * D {
                let (n, k) = (row / D, row % D);
                stiffness[(row, column)] = (behind[n][k] - ahead[n][k]) / (2.0 * step);
                viscosity[(row, column)] = at_rest[n][k] - moving[n][k];
            }
        }
        let symmetric = |m: DMatrix<f64>| (&m + m.transpose()) / 2.0;
        Self { stiffness: symmetric(stiffness), viscosity: symmetric(viscosity) }
    }
}

/// Degrees of freedom of the largest element.
const MOST: usize = 30;

fn gather<const D: usize>(nodes: &[u32], u: &[SVector<f64, D>], local: &mut [f64; MOST]) {
    for (i, &n) in nodes.iter().enumerate() {
        for k in 0..D {
            local[i * D + k] = u[n as usize][k];
        }
    }
}

/// Adds a packed symmetric matrix times a vector.
fn add_product(values: &[f32], size: usize, weight: f64, x: &[f64; MOST], y: &mut [f64; MOST]) {
    let mut values = values.iter();
    for row in 0..size {
        for column in row..size {
            let value = weight * f64::from(*values.next().unwrap_or(&0.0));
            y[row] += value * x[column];
            if column != row {
                y[column] += value * x[row];
            }
        }
    }
}

impl<const D: usize> Tie<D> {
    fn force(&self, relative: SVector<f64, D>) -> SVector<f64, D> {
        let along = self.normal * self.normal.dot(&relative);
        along * self.stiffness[0] + (relative - along) * self.stiffness[1]
    }
}
