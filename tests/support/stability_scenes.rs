//! Scenes whose longest stable time step is predicted and measured.

use yformat::{
    database::Database,
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};
use ypsilon::{
    scene::{Profile, Scene, SpatialContact, from_deck, spatial_from_deck},
    simulation::{Simulation, SpatialSimulation},
    stability::Limits,
};
use ypsilon_converters::dialects::convert_deck;

/// Young's modulus and density unless a scene says otherwise: an elastic wave takes about a second
/// for a metre.
pub const YOUNG: f64 = 1e4;
pub const DENSITY: f64 = 1e4;
const POISSON: f64 = 0.2;

/// Triangles or tetrahedra of one property set.
#[derive(Debug, Clone)]
pub struct Body {
    pub dimension: usize,
    /// Dialect of its deck.
    pub dialect: Dialect,
    pub coordinates: Vec<f64>,
    /// Velocities at the start; none if all nodes are at rest.
    pub velocities: Vec<f64>,
    /// Node set of each node: 0 free, 1 fixed, 2 loaded.
    pub sets: Vec<i64>,
    pub elements: Vec<i64>,
    pub young: f64,
    pub poisson: f64,
    pub density: f64,
    pub viscosity: f64,
    pub penalty: f64,
    /// Tangential penalty; a tenth of the penalty if not given.
    pub tangential: Option<f64>,
    /// Contact buffer, m.
    pub buffer: f64,
    /// The law of contact of tetrahedra.
    pub spatial_contact: SpatialContact,
    /// Penalty and strength of joints between all elements, if there are any.
    pub joints: Option<[f64; 2]>,
    /// Fracture energy of the joints; as much as their strength if not given.
    pub fracture_energy: Option<f64>,
    /// Coulomb coefficient.
    pub friction: f64,
    /// Along the last axis, m/s².
    pub gravity: f64,
    /// Force on each node of set 2 along the last axis, N.
    pub load: f64,
}

impl Body {
    /// No elements yet.
    pub fn new(dimension: usize) -> Self {
        Self {
            dimension,
            dialect: Dialect::Split,
            coordinates: Vec::new(),
            velocities: Vec::new(),
            sets: Vec::new(),
            elements: Vec::new(),
            young: YOUNG,
            poisson: POISSON,
            density: DENSITY,
            viscosity: 0.0,
            penalty: 0.0,
            tangential: None,
            buffer: 0.02,
            spatial_contact: SpatialContact::default(),
            joints: None,
            fracture_energy: None,
            friction: 0.0,
            gravity: 0.0,
            load: 0.0,
        }
    }

    /// One triangle or tetrahedron that is free.
    pub fn single(dimension: usize) -> Self {
        let corners: &[f64] = match dimension {
            2 => &[0.0, 0.0, 1.0, 0.1, 0.2, 0.8],
            _ => &[0.0, 0.0, 0.0, 1.0, 0.0, 0.1, 0.1, 0.9, 0.0, 0.2, 0.3, 0.8],
        };
        let nodes = corners.len() / dimension;
        let (coordinates, sets) = (corners.to_vec(), vec![0; nodes]);
        let elements = (0..nodes as i64).collect();
        Self { coordinates, sets, elements, ..Self::new(dimension) }
    }

    /// A rectangle of square cells of two triangles with its lower left corner at `from`. Nodes
    /// below `fixed` are fixed, those above `loaded` loaded; inner nodes are shifted by `skew` of
    /// a cell in turn.
    pub fn add_rectangle(&mut self, from: [f64; 2], cells: [usize; 2], size: f64, skew: f64) {
        let first = self.sets.len() as i64;
        let [columns, rows] = cells;
        let node = |i: usize, j: usize| first + (j * (columns + 1) + i) as i64;
        for j in 0..=rows {
            for i in 0..=columns {
                let inner = i > 0 && i < columns && j > 0 && j < rows;
                let shift = if inner { skew * [1.0, -0.7, 0.4][(i + 2 * j) % 3] } else { 0.0 };
                self.coordinates.push(from[0] + size * (i as f64 + shift));
                self.coordinates.push(from[1] + size * (j as f64 - 0.5 * shift));
                self.sets.push(0);
            }
        }
        for j in 0..rows {
            for i in 0..columns {
                self.elements.extend([node(i, j), node(i + 1, j), node(i + 1, j + 1)]);
                self.elements.extend([node(i, j), node(i + 1, j + 1), node(i, j + 1)]);
            }
        }
    }

    pub fn rectangle(cells: [usize; 2], size: f64, skew: f64) -> Self {
        let mut body = Self::new(2);
        body.add_rectangle([0.0, 0.0], cells, size, skew);
        body
    }

    /// A block of cubes of six tetrahedra, its lowest corner at `from`.
    pub fn add_block(&mut self, from: [f64; 3], cells: [usize; 3], size: f64) {
        let first = self.sets.len() as i64;
        let [nx, ny, nz] = cells;
        let node =
            |i: usize, j: usize, k: usize| first + ((k * (ny + 1) + j) * (nx + 1) + i) as i64;
        for k in 0..=nz {
            for j in 0..=ny {
                for i in 0..=nx {
                    let at = [i, j, k].map(|c| c as f64 * size);
                    self.coordinates.extend((0..3).map(|c| from[c] + at[c]));
                    self.sets.push(0);
                }
            }
        }
        for k in 0..nz {
            for j in 0..ny {
                for i in 0..nx {
                    // from one corner to the opposite one along the axes in all six orders
                    for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]]
                    {
                        let mut at = [i, j, k];
                        let mut corners = vec![node(at[0], at[1], at[2])];
                        for axis in order {
                            at[axis] += 1;
                            corners.push(node(at[0], at[1], at[2]));
                        }
                        let even = [[0, 1, 2], [1, 2, 0], [2, 0, 1]].contains(&order);
                        if !even {
                            corners.swap(2, 3);
                        }
                        self.elements.extend(corners);
                    }
                }
            }
        }
    }

    pub fn block(cells: [usize; 3], size: f64) -> Self {
        let mut body = Self::new(3);
        body.add_block([0.0; 3], cells, size);
        body
    }

    /// Puts nodes whose last coordinate is in a range into a set.
    pub fn put(mut self, set: i64, range: std::ops::RangeInclusive<f64>) -> Self {
        let places = self.coordinates.chunks(self.dimension);
        for (place, own) in places.zip(&mut self.sets) {
            if range.contains(&place[self.dimension - 1]) {
                *own = set;
            }
        }
        self
    }

    /// The deck of it.
    pub fn deck(&self) -> Deck {
        let d = self.dimension;
        let corners = d + 1;
        let (nodes, elements) = (self.sets.len() as i64, (self.elements.len() / corners) as i64);
        let (young, nu) = (self.young, self.poisson);
        let mu = young / (2.0 * (1.0 + nu));
        let lambda = young * nu / ((1.0 + nu) * (1.0 - 2.0 * nu));
        let zeros = vec![0.0; 3];
        let room = if self.joints.is_some() { 8 * elements } else { 0 };
        let axis = |k: usize| if k == d - 1 { vec![0.0, 0.0, self.load] } else { zeros.clone() };
        let mut deck = DeckBuilder::new(Dialect::Split)
            .integer("YDC/MCSTEP", 1_000_000)
            .real("YDC/DCSTEC", 1e-3)
            .integer("YDC/ICOUTF", 1_000_000)
            .real(if d == 2 { "YDC/DCGRAY" } else { "YDC/DCGRAZ" }, self.gravity)
            .integer("YDN/MNODIM", d as i64)
            .integer("YDN/NNODIM", d as i64)
            .integer("YDN/MNOPO", nodes + room)
            .integer("YDN/NNOPO", nodes)
            .reals2("YDN/D2NCI", d, self.coordinates.clone())
            .reals2("YDN/D2NCC", d, self.coordinates.clone())
            .integers("YDN/I1NOPR", self.sets.clone())
            .integers("YDN/I1NOBF", vec![1; nodes as usize])
            .integer("YDPN/MPNSET", 3)
            .integer("YDPN/NPNSET", 3)
            // what is loaded is led along the load
            .integers("YDPN/I1PNFX", vec![1, 3, 3])
            .integers("YDPN/I1PNFY", vec![1, 3, if d == 2 { 1 } else { 3 }])
            .reals("YDPN/D1PNAX", axis(0))
            .reals("YDPN/D1PNAY", axis(1));
        if d == 3 {
            deck = deck.integers("YDPN/I1PNFZ", vec![1, 3, 1]).reals("YDPN/D1PNAZ", axis(2));
        }
        deck = deck
            .integer("YDE/MELEM", elements + room)
            .integer("YDE/NELEM", elements)
            .integer("YDE/MELST", 2)
            .integer("YDE/MELNO", if d == 2 { 4 } else { 6 })
            .integer("YDE/NELNO", corners as i64)
            .integers("YDE/I1ELPR", vec![0; elements as usize])
            .integers2("YDE/I2ELTO", corners, self.elements.clone());
        if !self.velocities.is_empty() {
            deck = deck.reals2("YDN/D2NVC", d, self.velocities.clone());
        }
        if self.penalty > 0.0 {
            deck = deck
                .integer("YDI/MICOUP", 100_000)
                .real("YDI/DIEZON", self.buffer)
                .integer("YDI/IIECFF", -2)
                .real("YDI/DIEDI", 1e4 * self.buffer)
                .integer("YDI/MISTATE", 6);
        }
        deck = deck
            .integer("YDPE/MPROP", 1)
            .integer("YDPE/NPROP", 1)
            .reals("YDPE/D1PEKS", vec![self.viscosity])
            .reals("YDPE/D1PELA", vec![lambda])
            .reals("YDPE/D1PEMU", vec![mu])
            .reals("YDPE/D1PERO", vec![self.density])
            .reals("YDPE/D1PEPE", vec![self.penalty])
            .reals("YDPE/D1PEPT", vec![self.tangential.unwrap_or(0.1 * self.penalty)])
            .reals("YDPE/D1PEFR", vec![self.friction])
            .reals("YDPE/D1PSEM", vec![0.0])
            .integers("YDPE/I1PTYP", vec![if d == 2 { 1 } else { 21 }]);
        if let Some([penalty, strength]) = self.joints {
            deck = deck
                .integer("YDPJ/MPJSET", 1)
                .integer("YDPJ/NPJSET", 1)
                .reals("YDPJ/D1PJFT", vec![strength])
                .reals("YDPJ/D1PJFS", vec![strength])
                .reals("YDPJ/D1PJGF", vec![self.fracture_energy.unwrap_or(strength)])
                .reals("YDPJ/D1PJCO", vec![0.0])
                .reals("YDPJ/D1PJFR", vec![0.0])
                .reals("YDPJ/D1PJPE", vec![penalty])
                .integers("YDPJ/I1PTYP", vec![if d == 2 { 3 } else { 23 }])
                .integer("YDPM/MPMCOM", 1)
                .integer("YDPM/MPMCOL", 3)
                .integers2("YDPM/I2PMSET", 3, vec![1, 3, 0])
                .integer("YDPM/MPMROW", 1)
                .integers2("YDPM/I2PMIJ", 3, vec![0, 0, 0]);
        }
        let deck = deck.run().stop().build();
        match self.dialect {
            Dialect::Split => deck,
            other => convert_deck(&deck, other).expect("a deck of that dialect").deck,
        }
    }

    /// The simulation, meshed, at its start.
    pub fn simulation(&self) -> Moving {
        let deck = self.deck();
        let mut database = Database::new(deck.dialect());
        for item in deck.stages()[0].items.clone() {
            let findings = database.apply(&deck, item);
            assert!(findings.iter().all(|f| !f.is_error()), "{findings:?}");
        }
        let profile = Profile::default();
        if self.dimension == 2 {
            let built = from_deck(&deck, &database, "test", profile);
            let scene = built.scene.unwrap_or_else(|| panic!("{:?}", built.findings));
            let mut simulation = Simulation::new(scene);
            simulation.prepare().expect("room");
            Moving::Plane(Box::new(simulation))
        } else {
            let contact = self.spatial_contact;
            let built = spatial_from_deck(&deck, &database, "test", profile, contact);
            let scene = built.scene.unwrap_or_else(|| panic!("{:?}", built.findings));
            let mut simulation = SpatialSimulation::new(scene);
            simulation.prepare().expect("room");
            Moving::Space(Box::new(simulation))
        }
    }
}

/// A simulation of either dimension.
#[derive(Debug, Clone)]
pub enum Moving {
    Plane(Box<Simulation>),
    Space(Box<SpatialSimulation>),
}

impl Moving {
    pub fn limits(&self) -> Limits {
        match self {
            Self::Plane(simulation) => Limits::of_plane(simulation.scene()),
            Self::Space(simulation) => Limits::of_space(simulation.scene()),
        }
    }

    /// Does so many steps.
    pub fn run(&mut self, dt: f64, steps: usize) {
        match self {
            Self::Plane(simulation) => {
                let mut scene: Scene = simulation.scene().clone();
                scene.control.time_step = dt;
                simulation.continue_with(scene, None);
                simulation.prepare().expect("room");
                for _ in 0..steps {
                    simulation.evaluate_forces();
                    simulation.advance();
                }
            }
            Self::Space(simulation) => {
                let mut scene: Scene<3> = simulation.scene().clone();
                scene.control.time_step = dt;
                simulation.continue_with(scene, None);
                simulation.prepare().expect("room");
                for _ in 0..steps {
                    simulation.evaluate_forces();
                    simulation.advance();
                }
            }
        }
    }

    /// Gives nodes velocities that depend on their number and place.
    pub fn push(&mut self, velocity: impl Fn(usize, &[f64]) -> [f64; 3]) {
        match self {
            Self::Plane(simulation) => {
                let mut scene: Scene = simulation.scene().clone();
                for n in 0..scene.nodes.len() {
                    let [x, y, _] = velocity(n, scene.nodes.current[n].as_slice());
                    scene.nodes.velocity[n] = nalgebra::Vector2::new(x, y);
                }
                simulation.continue_with(scene, None);
            }
            Self::Space(simulation) => {
                let mut scene: Scene<3> = simulation.scene().clone();
                for n in 0..scene.nodes.len() {
                    let v = velocity(n, scene.nodes.current[n].as_slice());
                    scene.nodes.velocity[n] = nalgebra::Vector3::from(v);
                }
                simulation.continue_with(scene, None);
            }
        }
    }

    pub fn kinetic_energy(&self) -> f64 {
        match self {
            Self::Plane(simulation) => simulation.sum_kinetic_energy(),
            Self::Space(simulation) => simulation.sum_kinetic_energy(),
        }
    }

    /// Gives every node a small velocity of its own.
    pub fn disturb(&mut self, speed: f64) {
        let mut state = 0x9E37_79B9_7F4A_7C15_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        match self {
            Self::Plane(simulation) => {
                let mut scene: Scene = simulation.scene().clone();
                for v in &mut scene.nodes.velocity {
                    *v += nalgebra::Vector2::new(random(), random()) * speed;
                }
                simulation.continue_with(scene, None);
            }
            Self::Space(simulation) => {
                let mut scene: Scene<3> = simulation.scene().clone();
                for v in &mut scene.nodes.velocity {
                    *v += nalgebra::Vector3::new(random(), random(), random()) * speed;
                }
                simulation.continue_with(scene, None);
            }
        }
    }

    /// Whether a small disturbance grows without bound at a time step.
    pub fn diverges(&self, dt: f64) -> bool {
        let mut moving = self.clone();
        // small beside what closes contacts and opens joints
        moving.disturb(1e-9);
        moving.run(dt, 1);
        let start = moving.kinetic_energy().max(1e-14);
        for _ in 0..20 {
            moving.run(dt, 100);
            let energy = moving.kinetic_energy();
            if energy.is_nan() || energy >= 1e4 * start {
                return true;
            }
        }
        false
    }

    /// The longest time step that is stable, by bisection to 0.2 %.
    pub fn measured_limit(&self, guess: f64) -> f64 {
        let (mut stable, mut unstable) = (0.5 * guess, 2.0 * guess);
        while unstable / stable > 1.002 {
            let middle = (stable * unstable).sqrt();
            if self.diverges(middle) {
                unstable = middle;
            } else {
                stable = middle;
            }
        }
        stable
    }
}
