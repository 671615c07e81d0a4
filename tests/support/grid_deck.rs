//! Decks of rectangular walls made of square cells of two triangles, each
//! triangle on joints: large enough for all threads to have work.

use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// A wall of `columns` × `rows` cells of 0.1 m standing on its fixed lowest
/// nodes, loaded by gravity and by a push at the top.
pub fn jointed_wall(columns: usize, rows: usize, steps: i64) -> Deck {
    let node = |i: usize, j: usize| (j * (columns + 1) + i) as i64;
    let mut coordinates = Vec::new();
    let mut sets = Vec::new();
    for j in 0..=rows {
        for i in 0..=columns {
            coordinates.extend([0.1 * i as f64, 0.1 * j as f64]);
            sets.push(if j == 0 { 1 } else { i64::from(j == rows) * 2 });
        }
    }
    let mut triangles = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            triangles.extend([node(i, j), node(i + 1, j), node(i + 1, j + 1)]);
            triangles.extend([node(i, j), node(i + 1, j + 1), node(i, j + 1)]);
        }
    }
    let (nodes, elements) = (sets.len(), triangles.len() / 3);
    DeckBuilder::new(Dialect::Split)
        .integer("YDC/MCSTEP", steps)
        .real("YDC/DCSTEC", 2e-6)
        .real("YDC/DCGRAY", -9.81)
        .integer("YDC/ICOUTF", 1_000_000)
        .integer("YDN/MNODIM", 2)
        .integer("YDN/NNODIM", 2)
        .integer("YDN/MNOPO", (nodes + 3 * elements) as i64)
        .integer("YDN/NNOPO", nodes as i64)
        .reals2("YDN/D2NCI", 2, coordinates.clone())
        .reals2("YDN/D2NCC", 2, coordinates)
        .integers("YDN/I1NOPR", sets)
        .integers("YDN/I1NOBF", vec![1; nodes])
        .integer("YDPN/MPNSET", 3)
        .integer("YDPN/NPNSET", 3)
        .integers("YDPN/I1PNFX", vec![1, 3, 1])
        .integers("YDPN/I1PNFY", vec![1, 3, 1])
        .reals("YDPN/D1PNAX", vec![0.0, 0.0, 4e4])
        .reals("YDPN/D1PNAY", vec![0.0; 3])
        .integer("YDE/MELEM", 4 * elements as i64)
        .integer("YDE/NELEM", elements as i64)
        .integer("YDE/MELST", 2)
        .integer("YDE/MELNO", 4)
        .integer("YDE/NELNO", 3)
        .integers("YDE/I1ELPR", vec![0; elements])
        .integers2("YDE/I2ELTO", 3, triangles)
        .integer("YDI/MICOUP", 1_000_000)
        .real("YDI/DIEZON", 0.01)
        .integer("YDI/IIECFF", -2)
        .real("YDI/DIEDI", 200.0)
        .integer("YDI/MISTATE", 6)
        .integer("YDPE/MPROP", 1)
        .integer("YDPE/NPROP", 1)
        .reals("YDPE/D1PEKS", vec![1e4])
        .reals("YDPE/D1PELA", vec![2e9])
        .reals("YDPE/D1PEMU", vec![3e9])
        .reals("YDPE/D1PERO", vec![2500.0])
        .reals("YDPE/D1PEPE", vec![5e10])
        .reals("YDPE/D1PEPT", vec![5e9])
        .reals("YDPE/D1PEFR", vec![0.6])
        .reals("YDPE/D1PSEM", vec![0.0])
        .integers("YDPE/I1PTYP", vec![1])
        .integer("YDPJ/MPJSET", 1)
        .integer("YDPJ/NPJSET", 1)
        .reals("YDPJ/D1PJFT", vec![1e5])
        .reals("YDPJ/D1PJFS", vec![2e5])
        .reals("YDPJ/D1PJGF", vec![5.0])
        .reals("YDPJ/D1PJCO", vec![2e5])
        .reals("YDPJ/D1PJFR", vec![0.6])
        .reals("YDPJ/D1PJPE", vec![1e11])
        .integers("YDPJ/I1PTYP", vec![3])
        .integer("YDPM/MPMCOM", 1)
        .integer("YDPM/MPMCOL", 3)
        .integers2("YDPM/I2PMSET", 3, vec![1, 3, 0])
        .integer("YDPM/MPMROW", 1)
        .integers2("YDPM/I2PMIJ", 3, vec![0, 0, 0])
        .run()
        .stop()
        .build()
}
