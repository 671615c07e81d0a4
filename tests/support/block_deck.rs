//! A block of cubes whose fields are known by hand: every node has a given place and moves with a
//! given velocity.

use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// Cubes along x, y and z.
pub const CUBES: [usize; 3] = [4, 2, 2];
/// Side of a cube, m.
pub const CUBE: f64 = 0.1;
/// Six tetrahedra of a cube around its diagonal; corner `i` lies at bit 0 of `i` along x, bit 1 along y and bit 2
/// along z.
pub const SIX_TETRAHEDRA: [[usize; 4]; 6] =
    [[0, 1, 3, 7], [0, 5, 1, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 4, 5, 7], [0, 6, 4, 7]];
/// Lamé's first constant, Pa.
pub const LAMBDA: f64 = 4e8;
/// Shear modulus, Pa.
pub const MU: f64 = 3e8;
/// Density, kg/m³.
pub const DENSITY: f64 = 2000.0;
/// Time step, s.
pub const STEP: f64 = 1e-6;

/// Lengths of the block along x, y and z, m.
pub fn lengths() -> [f64; 3] {
    CUBES.map(|n| n as f64 * CUBE)
}

/// Number of the node in these rows along x, y and z.
pub fn node([i, j, k]: [usize; 3]) -> usize {
    i + (CUBES[0] + 1) * (j + (CUBES[1] + 1) * k)
}

/// The block in tetrahedra, six in each cube, with nodes of the undeformed place x at
/// `displaced(x)`; all of them move with this velocity from then on. Results are written at
/// every `every` of so many steps.
pub fn block(
    displaced: impl Fn([f64; 3]) -> [f64; 3],
    velocity: [f64; 3],
    steps: i64,
    every: i64,
) -> Deck {
    let rows = CUBES.map(|n| n + 1);
    let (mut initial, mut current, mut velocities) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..rows[2] {
        for j in 0..rows[1] {
            for i in 0..rows[0] {
                let place = [i, j, k].map(|row| row as f64 * CUBE);
                initial.extend(place);
                current.extend(displaced(place));
                velocities.extend(velocity);
            }
        }
    }
    let mut corners = Vec::new();
    for k in 0..CUBES[2] {
        for j in 0..CUBES[1] {
            for i in 0..CUBES[0] {
                let corner = |c: usize| node([i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)]) as i64;
                for tetrahedron in SIX_TETRAHEDRA {
                    corners.extend(tetrahedron.map(corner));
                }
            }
        }
    }
    let (nodes, elements) = (initial.len() as i64 / 3, corners.len() as i64 / 4);
    let mut deck = DeckBuilder::new(Dialect::Split)
        .integer("YDC/MCSTEP", steps)
        .real("YDC/DCSTEC", STEP)
        .integer("YDC/ICOUTF", every)
        .integer("YDN/MNODIM", 3)
        .integer("YDN/NNODIM", 3)
        .integer("YDN/MNOPO", nodes)
        .integer("YDN/NNOPO", nodes)
        .reals2("YDN/D2NCI", 3, initial)
        .reals2("YDN/D2NCC", 3, current)
        .reals2("YDN/D2NVC", 3, velocities)
        .integers("YDN/I1NOPR", vec![0; nodes as usize])
        .integer("YDPN/MPNSET", 1)
        .integer("YDPN/NPNSET", 1)
        .integer("YDE/MELEM", elements)
        .integer("YDE/NELEM", elements)
        .integer("YDE/MELST", 1)
        .integer("YDE/MELNO", 6)
        .integer("YDE/NELNO", 4)
        .integers("YDE/I1ELPR", vec![0; elements as usize])
        .integers2("YDE/I2ELTO", 4, corners)
        .integer("YDPE/MPROP", 1)
        .integer("YDPE/NPROP", 1)
        .integers("YDPE/I1PTYP", vec![21])
        .reals("YDPE/D1PELA", vec![LAMBDA])
        .reals("YDPE/D1PEMU", vec![MU])
        .reals("YDPE/D1PERO", vec![DENSITY]);
    for (axis, speed) in ["X", "Y", "Z"].into_iter().zip(velocity) {
        deck = deck
            .integers(&format!("YDPN/I1PNF{axis}"), vec![3])
            .reals(&format!("YDPN/D1PNA{axis}"), vec![speed]);
    }
    deck.run().stop().build()
}
