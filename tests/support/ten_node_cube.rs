//! The thesis's confined cube with ten-node tetrahedra.

use ypsilon::mechanics::tetrahedron10;

/// Deck 04 with ten-node tetrahedra: twelve of them in a cube that only its upper face lets be
/// pressed, loaded by 1/6 of the force at the nodes on the edges of that face and 1/3 on its
/// diagonal, so that it is strained by 1 %. The deck and its number of nodes.
pub fn confined_cube_of_ten_nodes(poisson: f64) -> (String, usize) {
    let (young, density) = (26e9, 1000.0);
    let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    let mu = young / (2.0 * (1.0 + poisson));
    let (modulus, stretch) = (lambda + 2.0 * mu, 0.99_f64);
    let speed = (modulus / density).sqrt();
    let force = -(mu * (stretch * stretch - 1.0) + lambda * stretch.ln()) / stretch;
    let mut places: Vec<[f64; 3]> = (0..8)
        .map(|i| [(i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64])
        .chain([[0.5; 3]])
        .collect();
    let faces =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let halves = faces.into_iter().flat_map(|[a, b, c, d]| [[a, b, c, 8], [a, c, d, 8]]);
    let mut elements = String::new();
    for corners in halves {
        let mut nodes: Vec<usize> = corners.to_vec();
        for [a, b] in tetrahedron10::EDGES {
            let (a, b) = (places[corners[a]], places[corners[b]]);
            let middle = std::array::from_fn(|k| (a[k] + b[k]) / 2.0);
            let known = places.iter().position(|place| *place == middle);
            nodes.push(known.unwrap_or_else(|| {
                places.push(middle);
                places.len() - 1
            }));
        }
        nodes.iter().for_each(|n| elements += &format!("{n} "));
        elements += "1\n";
    }
    // 0 bottom, 1 walls and corners of the top, 2 its edges, 3 its diagonal, 4 inside
    let set = |[x, y, z]: [f64; 3]| {
        let on_wall = |c: f64| c == 0.0 || c == 1.0;
        match (z, x == 0.5, y == 0.5) {
            (0.0, ..) => 0,
            (1.0, true, true) => 3,
            (1.0, true, _) | (1.0, _, true) => 2,
            _ if on_wall(x) || on_wall(y) || z == 1.0 => 1,
            _ => 4,
        }
    };
    let sets: String = places.iter().map(|&place| format!("{} ", set(place))).collect();
    let rows: String = places.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
    let (n, ones) = (places.len(), "1 ".repeat(12));
    let (edge, diagonal) = (-force / 6.0, -force / 3.0);
    let deck = format!(
        "/YD/YDC/MCSTEP 6000 /YD/YDC/DCSTEC {} /YD/YDC/INITER 0 /YD/YDC/ICOUTF 6000
/YD/YDE/MELEM 12 /YD/YDE/NELEM 12 /YD/YDE/MELNO 12 /YD/YDE/NELNO 11
/YD/YDE/I1ELBE 12 {ones} /YD/YDE/I1ELPR 12 {} /YD/YDE/I2ELTO 21 11 12\n{elements}
/YD/YDN/MNODIM 4 /YD/YDN/NNODIM 3 /YD/YDN/MNOPO {n} /YD/YDN/NNOPO {n}
/YD/YDN/D2NCC 21 3 {n}\n{rows}/YD/YDN/D2NCI 21 3 {n}\n{rows}/YD/YDN/I1NOPR {n} {sets}
/YD/YDP/MPROP 1 /YD/YDP/NPROP 1 /YD/YDP/I1PTYP 1 11 /YD/YDP/D1PELA 1 {lambda}
/YD/YDP/D1PEMU 1 {mu} /YD/YDP/D1PERO 1 {density} /YD/YDP/D1PEKS 1 {}
/YD/YDB/MBCON 5 /YD/YDB/NBCON 5 /YD/YDB/I1BNVX 5 1 1 1 1 0 /YD/YDB/I1BNVY 5 1 1 1 1 0
/YD/YDB/I1BNVZ 5 1 0 0 0 0 /YD/YDB/D1BNFZ 5 0 0 {edge} {diagonal} 0
$YDOIT
$YSTOP
",
        0.008 / speed,
        "0 ".repeat(12),
        0.3 * modulus / speed,
    );
    (deck, n)
}
