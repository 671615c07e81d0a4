//! Decks of planar bodies of one material, for scenes that no generator makes.

use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// A plane scene of one material: concrete as in the speed scenes of the original.
#[derive(Debug, Clone)]
pub(super) struct PlaneDeck {
    /// Places of the nodes, m.
    pub nodes: Vec<[f64; 2]>,
    /// Their velocities at the start, m/s.
    pub velocities: Vec<[f64; 2]>,
    /// Which of them are held.
    pub held: Vec<bool>,
    /// Corners of the triangles, counter-clockwise.
    pub triangles: Vec<[usize; 3]>,
    /// Length of a time step, s.
    pub step_s: f64,
    /// Distance up to which triangles are watched for contact, m; none where nothing touches.
    pub buffer_m: Option<f64>,
    /// Joints between all triangles.
    pub joints: Option<Joints>,
}

/// Strengths of joints.
#[derive(Debug, Clone, Copy)]
pub(super) struct Joints {
    /// Tensile strength, Pa.
    pub tensile_pa: f64,
    /// Shear strength and cohesion, Pa.
    pub shear_pa: f64,
    /// Fracture energy, N/m.
    pub fracture_energy_n_m: f64,
    /// Penalty, Pa.
    pub penalty_pa: f64,
}

impl PlaneDeck {
    /// A scene without bodies.
    pub fn empty(step_s: f64) -> Self {
        Self {
            nodes: Vec::new(),
            velocities: Vec::new(),
            held: Vec::new(),
            triangles: Vec::new(),
            step_s,
            buffer_m: None,
            joints: None,
        }
    }

    /// Adds a node at rest and gives its number.
    pub fn node(&mut self, place: [f64; 2], is_held: bool) -> usize {
        self.nodes.push(place);
        self.velocities.push([0.0; 2]);
        self.held.push(is_held);
        self.nodes.len() - 1
    }

    /// The deck of the split dialect, for so many steps, with one state at its start.
    pub fn build(self, steps: u64) -> Deck {
        let (nodes, triangles) = (self.nodes.len(), self.triangles.len());
        let steps = i64::try_from(steps).unwrap_or(i64::MAX);
        let places: Vec<f64> = self.nodes.into_iter().flatten().collect();
        let builder = DeckBuilder::new(Dialect::Split)
            .integer("YDC/MCSTEP", steps)
            .integer("YDC/NCSTEP", 0)
            .real("YDC/DCSTEC", self.step_s)
            .real("YDC/DCTIME", 0.0)
            .integer("YDC/ICOUTF", steps)
            .real("YDC/DCGRAY", -9.81)
            .integer("YDN/MNODIM", 2)
            .integer("YDN/NNODIM", 2)
            .integer("YDN/MNOPO", length(nodes + 3 * triangles + 10))
            .integer("YDN/NNOPO", length(nodes))
            .reals2("YDN/D2NCC", 2, places.clone())
            .reals2("YDN/D2NCI", 2, places)
            .reals2("YDN/D2NVC", 2, self.velocities.into_iter().flatten().collect())
            .integers("YDN/I1NOBF", vec![1; nodes])
            .integers("YDN/I1NOPR", self.held.into_iter().map(i64::from).collect())
            .integer("YDPN/MPNSET", 2)
            .integer("YDPN/NPNSET", 2)
            .integers("YDPN/I1PNFX", vec![1, 3])
            .integers("YDPN/I1PNFY", vec![1, 3])
            .reals("YDPN/D1PNAX", vec![0.0; 2])
            .reals("YDPN/D1PNAY", vec![0.0; 2])
            .integer("YDE/MELEM", length(4 * triangles + 10))
            .integer("YDE/NELEM", length(triangles))
            .integer("YDE/MELST", 2)
            .integer("YDE/NELST", 2)
            .integer("YDE/MELNO", 4)
            .integer("YDE/NELNO", 3)
            .integers("YDE/I1ELPR", vec![0; triangles])
            .integers2("YDE/I2ELTO", 3, self.triangles.into_iter().flatten().map(length).collect());
        let builder = match self.buffer_m {
            None => builder.integer("YDI/MICOUP", 0),
            Some(buffer) => builder
                .integer("YDI/MICOUP", length(40 * triangles))
                .integer("YDI/NICOUP", 0)
                .real("YDI/DIEZON", buffer)
                .integer("YDI/IIECFF", -2)
                .real("YDI/DIEDI", 200.0)
                .integer("YDI/MISTATE", 6),
        };
        let builder = materials(builder.kinetic_energy_history(5e-4));
        match self.joints {
            None => builder,
            Some(joints) => insertion(builder, joints),
        }
        .run()
        .stop()
        .build()
    }
}

/// Young's modulus 25 GPa, Poisson's ratio 0.2.
fn materials(builder: DeckBuilder) -> DeckBuilder {
    builder
        .integer("YDPE/MPROP", 1)
        .integer("YDPE/NPROP", 1)
        .reals("YDPE/D1PEKS", vec![2e4])
        .reals("YDPE/D1PELA", vec![6944444444.444445])
        .reals("YDPE/D1PEMU", vec![10416666666.666668])
        .reals("YDPE/D1PERO", vec![2400.0])
        .reals("YDPE/D1PEPE", vec![2.5e11])
        .reals("YDPE/D1PEPT", vec![2.5e10])
        .reals("YDPE/D1PEFR", vec![0.57])
        .reals("YDPE/D1PSEM", vec![0.0])
        .integers("YDPE/I1PEFR", vec![0])
        .integers("YDPE/I1PEMB", vec![0])
        .integers("YDPE/I1PSDE", vec![0])
        .integers("YDPE/I1PTYP", vec![1])
}

fn insertion(builder: DeckBuilder, joints: Joints) -> DeckBuilder {
    builder
        .integer("YDPJ/MPJSET", 1)
        .integer("YDPJ/NPJSET", 1)
        .reals("YDPJ/D1PJFS", vec![joints.shear_pa])
        .reals("YDPJ/D1PJFT", vec![joints.tensile_pa])
        .reals("YDPJ/D1PJCO", vec![joints.shear_pa])
        .reals("YDPJ/D1PJFR", vec![0.6])
        .reals("YDPJ/D1PJPE", vec![joints.penalty_pa])
        .reals("YDPJ/D1PJGF", vec![joints.fracture_energy_n_m])
        .integers("YDPJ/I1PSDE", vec![0])
        .integers("YDPJ/I1PTYP", vec![3])
        .integer("YDPM/MPMCOM", 1)
        .integer("YDPM/MPMCOL", 3)
        .integers2("YDPM/I2PMSET", 3, vec![1, 3, 0])
        .integer("YDPM/MPMROW", 1)
        .integers2("YDPM/I2PMIJ", 3, vec![0, 0, 0])
}

fn length(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}
