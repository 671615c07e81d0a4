//! A plate of square cells whose fields are known by hand.

use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// Cells along either side.
pub const CELLS: usize = 4;
/// Side of the plate, m.
pub const SIDE: f64 = 0.4;
/// Load on its upper edge, N, downwards.
pub const LOAD: f64 = 8e3;

/// What holds and moves the plate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Case {
    /// Every node is where x′ = x + 0.002 x + 0.001 y, y′ = y − 0.003 y puts it and never moves.
    LinearDisplacement,
    /// It stands on rollers (set 1), its lower left corner (set 4) held, under [`LOAD`] on its
    /// upper nodes (set 2, corners with half the force set 3), damped to rest.
    Loaded,
}

/// The linear displacement of [`Case::LinearDisplacement`].
pub fn displacement(x: f64, y: f64) -> [f64; 2] {
    [0.002 * x + 0.001 * y, -0.003 * y]
}

/// Number of the node in column `i` and row `j`.
pub fn node(i: usize, j: usize) -> usize {
    j * (CELLS + 1) + i
}

/// The deck.
pub fn plate(case: Case, steps: i64) -> Deck {
    let cell = SIDE / CELLS as f64;
    let (mut initial, mut current, mut sets) = (Vec::new(), Vec::new(), Vec::new());
    for j in 0..=CELLS {
        for i in 0..=CELLS {
            let (x, y) = (cell * i as f64, cell * j as f64);
            initial.extend([x, y]);
            let u = if case == Case::Loaded { [0.0; 2] } else { displacement(x, y) };
            current.extend([x + u[0], y + u[1]]);
            sets.push(match (case, i, j) {
                (Case::LinearDisplacement, ..) => 4,
                (_, 0, 0) => 4,
                (_, _, 0) => 1,
                (_, 0 | CELLS, CELLS) => 3,
                (_, _, CELLS) => 2,
                _ => 0,
            });
        }
    }
    let number = |i, j| node(i, j) as i64;
    let mut triangles = Vec::new();
    for j in 0..CELLS {
        for i in 0..CELLS {
            triangles.extend([number(i, j), number(i + 1, j), number(i + 1, j + 1)]);
            triangles.extend([number(i, j), number(i + 1, j + 1), number(i, j + 1)]);
        }
    }
    let (nodes, elements) = (sets.len(), triangles.len() / 3);
    let share = LOAD / CELLS as f64;
    DeckBuilder::new(Dialect::Split)
        .integer("YDC/MCSTEP", steps)
        .real("YDC/DCSTEC", 2e-6)
        .integer("YDC/ICOUTF", (steps - 1).max(1))
        .integer("YDN/MNODIM", 2)
        .integer("YDN/NNODIM", 2)
        .integer("YDN/MNOPO", nodes as i64)
        .integer("YDN/NNOPO", nodes as i64)
        .reals2("YDN/D2NCI", 2, initial)
        .reals2("YDN/D2NCC", 2, current)
        .integers("YDN/I1NOPR", sets)
        .integer("YDPN/MPNSET", 5)
        .integer("YDPN/NPNSET", 5)
        .integers("YDPN/I1PNFX", vec![1, 1, 1, 1, 3])
        .integers("YDPN/I1PNFY", vec![1, 3, 1, 1, 3])
        .reals("YDPN/D1PNAX", vec![0.0; 5])
        .reals("YDPN/D1PNAY", vec![0.0, 0.0, -share, -0.5 * share, 0.0])
        .integer("YDE/MELEM", elements as i64)
        .integer("YDE/NELEM", elements as i64)
        .integer("YDE/MELST", 2)
        .integer("YDE/MELNO", 4)
        .integer("YDE/NELNO", 3)
        .integers("YDE/I1ELPR", vec![0; elements])
        .integers2("YDE/I2ELTO", 3, triangles)
        .integer("YDPE/MPROP", 1)
        .integer("YDPE/NPROP", 1)
        .reals("YDPE/D1PEKS", vec![if case == Case::Loaded { 5e5 } else { 0.0 }])
        .reals("YDPE/D1PELA", vec![4e8])
        .reals("YDPE/D1PEMU", vec![4e8])
        .reals("YDPE/D1PERO", vec![2500.0])
        .integers("YDPE/I1PTYP", vec![1])
        .run()
        .stop()
        .build()
}
