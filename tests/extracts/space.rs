//! Tables from results of tetrahedra.

use super::{near, selection, support, value, ypsilon};
use std::{fs, path::Path};
use support::{
    block_deck::{CUBE, CUBES, DENSITY, LAMBDA, MU, STEP, block, lengths, node},
    results::results,
    spoilt_deck::write,
    ten_node_cube::confined_cube_of_ten_nodes,
};
use tempfile::TempDir;
use yformat::deck::Deck;
use ypsilon_post::{
    Point, PostError,
    extract::{
        self, Place, along, energy, extremes, force_displacement, histories, joint_counts, top_line,
    },
    field::Field,
    results::{FrameChoice, Results},
    table::Table,
};

/// Stretches along x, y and z: the block is pressed along x and may not widen as it wants to.
const STRETCH: [f64; 3] = [0.99, 1.001, 1.002];

fn stretched(x: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|axis| STRETCH[axis] * x[axis])
}

/// Cauchy stress along x, y and z.
fn by_hand() -> [f64; 3] {
    let j: f64 = STRETCH.iter().product();
    STRETCH.map(|l| MU / j * (l * l - 1.0) + 0.5 * LAMBDA * (j - 1.0 / j))
}

fn fields(names: &str) -> Vec<Field> {
    names.split(',').map(|name| name.parse().expect("a field")).collect()
}

fn at_rest() -> TempDir {
    results(&block(stretched, [0.0; 3], 2, 1), &[], 1)
}

#[test]
fn a_pressed_block_has_constant_stress_and_straight_lines() {
    let folder = at_rest();
    let [xx, yy, zz] = by_hand();
    let path = extract::Path::Line([[0.01, 0.02, 0.03], [0.39, 0.17, 0.11]].map(Point::Space));
    let asked = fields("sxx,syy,szz,sxy,syz,szx,von-mises,tresca,s1,s3,mean-stress,ux,uy,uz");
    let von_mises = (0.5 * ((xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2))).sqrt();
    // VTU files, and a d3plot family in single precision
    for (name, tolerance) in [("plate.pvd", 1e-9), ("plate", 2e-5)] {
        let mut results = Results::open(&folder.path().join(name)).expect("results");
        assert_eq!(results.dimension().ok(), Some(3));
        let line = along(&mut results, &path, 40, &asked, &[FrameChoice::Last]).expect("a table");
        assert_eq!(line.headings[..5], ["time (s)", "s (m)", "x (m)", "y (m)", "z (m)"]);
        for (row, cells) in line.rows.iter().enumerate() {
            let [length, x, y, z] = [cells[1], cells[2], cells[3], cells[4]];
            near(length, (x - 0.01).hypot(y - 0.02).hypot(z - 0.03), 1e-12, "length");
            for (field, expected) in [
                ("sxx", xx),
                ("syy", yy),
                ("szz", zz),
                ("von-mises", von_mises),
                ("tresca", zz - xx),
                ("s1", zz),
                ("s3", xx),
                ("mean-stress", (xx + yy + zz) / 3.0),
                ("ux", -0.01 * x),
                ("uy", 0.001 * y),
                ("uz", 0.002 * z),
            ] {
                // displacements are differences of coordinates in single precision
                let scale = if field.starts_with('u') { 0.01 * lengths()[0] } else { 0.0 };
                let off = (value(&line, row, field) - expected).abs();
                assert!(off <= tolerance * expected.abs().max(scale), "{field}: off by {off}");
            }
            for field in ["sxy", "syz", "szx"] {
                assert!(value(&line, row, field).abs() < tolerance * xx.abs(), "{field}");
            }
        }
    }
}

#[test]
fn supports_carry_what_the_stress_gives() {
    let folder = at_rest();
    let mut results = Results::open(folder.path()).expect("a folder with one collection");
    let [xx, yy, zz] = by_hand();
    let [_, width, height] = lengths();
    let (right, upper) = (selection("box:0.399:,,"), selection("box:,,0.199:"));
    let pushed = force_displacement(&mut results, &right, &upper).expect("a table");
    assert_eq!(
        pushed.headings,
        [
            "time (s)",
            "mean displacement ux (m)",
            "mean displacement uy (m)",
            "mean displacement uz (m)",
            "reaction x (N)",
            "reaction y (N)",
            "reaction z (N)"
        ]
    );
    // the stress acts on the deformed face
    let face = STRETCH[1] * width * STRETCH[2] * height;
    near(value(&pushed, 0, "reaction x"), xx * face, 1e-9, "reaction x");
    near(value(&pushed, 0, "mean displacement uz"), 0.002 * height, 1e-9, "uz");
    near(value(&pushed, 0, "mean displacement ux"), -0.01 * 0.5 * lengths()[0], 1e-9, "ux");
    // what lies on one edge of the block, by another selection
    let edge = selection("line:0,0,0.2,0.4,0,0.2");
    let edge = force_displacement(&mut results, &edge, &edge).expect("a table");
    near(value(&edge, 0, "mean displacement uz"), 0.002 * height, 1e-9, "uz of the edge");
    let cubes = CUBES[0] as f64 + 1.0;
    let along_edge = -0.01 * CUBE * (cubes - 1.0) / 2.0;
    near(value(&edge, 0, "mean displacement ux"), along_edge, 1e-9, "ux of the edge");

    let table = extremes(&mut results, &fields("uz,syy,x")).expect("a table");
    near(value(&table, 1, "max uz"), 0.002 * height, 1e-9, "largest uz");
    near(value(&table, 1, "z of max uz"), 1.002 * height, 1e-12, "its height");
    near(value(&table, 1, "min syy"), yy, 1e-9, "σyy");
    assert_eq!(value(&table, 1, "x of min x"), 0.0);
    assert!(zz > yy && yy > xx);
}

#[test]
fn a_moving_block_keeps_its_shape() {
    let turned = |[x, y, z]: [f64; 3]| [-y + 0.5, x, z + 0.25];
    let velocity = [3.0, -2.0, 6.0];
    let folder = results(&block(turned, velocity, 4, 1), &[], 1);
    let mut results = Results::open(&folder.path().join("plate.pvd")).expect("a series");
    let mass = DENSITY * lengths().iter().product::<f64>();
    let energies = energy(&mut results).expect("a table");
    assert_eq!(energies.rows.len(), 4);
    let (point, corner) = ([0.13, 0.07, 0.16], [0.4, 0.2, 0.2]);
    let places = [
        Place::Node(node([4, 2, 2])),
        Place::Point(Point::Space(point)),
        Place::Nearest(Point::Space([0.39, 0.21, 0.3])),
    ];
    let asked = fields("ux,uy,uz,vz,von-mises");
    let history = histories(&mut results, &places, &asked).expect("a table");
    assert_eq!(history.headings[8], "uz at (0.13; 0.07; 0.16) (m)");
    for (row, cells) in history.rows.iter().enumerate() {
        near(energies.rows[row][1], 0.5 * mass * 49.0, 1e-12, "kinetic energy");
        let time = row as f64 * STEP;
        for (place, x) in [corner, point, corner].into_iter().enumerate() {
            let there = turned(x);
            for axis in 0..3 {
                let expected = there[axis] - x[axis] + velocity[axis] * time;
                let found = cells[1 + 5 * place + axis];
                assert!((found - expected).abs() < 1e-14, "{place} {axis}: {found} {expected}");
            }
            near(cells[4 + 5 * place], 6.0, 1e-14, "vz");
            assert!(cells[5 + 5 * place] < 1e-6 * MU, "no stress");
        }
    }
    let end = lengths();
    for corner in [[0.0; 3], end] {
        // corners of the block are found in spite of rounding
        let places = [Place::Point(Point::Space(corner))];
        histories(&mut results, &places, &asked).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn nodes_on_edges_bend_lines() {
    let (deck, nodes) = confined_cube_of_ten_nodes(0.3);
    let folder = TempDir::new().expect("a folder");
    let deck = deck.replace("/YD/YDC/ICOUTF 6000", "/YD/YDC/ICOUTF 5999");
    write(folder.path(), "plate.Y3D", deck.as_bytes());
    let run = ["run", "plate.Y3D", "--out", ".", "--quiet", "--formats", "vtu"];
    let (code, _, told) = ypsilon(folder.path(), &run);
    assert_eq!(code, Some(0), "{told}");
    let mut results = Results::open(folder.path()).expect("a folder with one collection");
    // strained by 1 % along z, so that uz = −0.01 z at corners, on edges and between
    let first = results.frame_in::<3, 4>(0).expect("a frame");
    let initial = first.initial();
    let on_edge = (0..nodes).find(|&n| initial[n] == [0.25, 0.25, 0.25]).expect("a node");
    let places = [
        Place::Node(on_edge),
        Place::Nearest(Point::Space([0.26, 0.24, 0.25])),
        Place::Point(Point::Space([0.3, 0.55, 0.7])),
    ];
    let history = histories(&mut results, &places, &fields("uz,szz")).expect("a table");
    let end = &history.rows[history.rows.len() - 1];
    near(end[1], -0.0025, 1e-3, "uz of a node on an edge");
    assert_eq!(end[1..3], end[3..5]);
    near(end[5], -0.007, 1e-3, "uz within");
    let (young, poisson) = (26e9, 0.3);
    let lambda = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
    let mu = young / (2.0 * (1.0 + poisson));
    let stress = (mu * (0.99_f64.powi(2) - 1.0) + lambda * 0.99_f64.ln()) / 0.99;
    near(end[6], stress, 1e-3, "σzz");
    // all nodes of the upper face carry the load, those on edges among them
    let upper = selection("box:,,0.999:");
    let pushed = force_displacement(&mut results, &upper, &upper).expect("a table");
    near(value(&pushed, pushed.rows.len() - 1, "mean displacement uz"), -0.01, 1e-3, "uz");
    near(value(&pushed, pushed.rows.len() - 1, "reaction z"), stress, 1e-3, "reaction z");
}

#[test]
fn joints_in_space_have_areas() {
    let name = "t3d_joint_tension";
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/split3d");
    let deck = fs::read_to_string(data.join(name).join(format!("{name}.y"))).expect("a deck");
    let deck = deck.replace("/YD/YDC/ICOUTF 3000", "/YD/YDC/ICOUTF 2999");
    let parsed = Deck::parse("plate.y", deck);
    assert!(!parsed.has_errors());
    let folder = results(&parsed.deck, &[], 1);
    for file in ["plate.pvd", "plate"] {
        let mut results = Results::open(&folder.path().join(file)).expect("results");
        let table = joint_counts(&mut results).expect("a table");
        assert_eq!(table.headings[8], "broken area (m²)");
        let [start, end] = [&table.rows[0], &table.rows[table.rows.len() - 1]];
        // a crack across the cube of 1 m, pulled along z
        assert_eq!(start[1..], [72.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
        let [tension, unknown] = if file == "plate" { [0.0, 8.0] } else { [8.0, 0.0] };
        assert_eq!(end[1..8], [64.0, 0.0, 8.0, tension, 0.0, 0.0, unknown]);
        near(end[8], 1.0, 1e-3, "area of the crack");
    }
}

/// The program on the results of a block at rest.
fn told(folder: &Path, words: &[&str]) -> (Option<i32>, String) {
    let (code, _, told) =
        ypsilon(folder, &[&["extract", "plate.pvd", "--what"][..], words].concat());
    (code, told)
}

#[test]
fn the_command_makes_tables_of_space_and_tells_what_is_wrong() {
    let folder = at_rest();
    let folder = folder.path();
    let (code, told_of) = told(folder, &["history", "--point", "0.1,0.1,0.1", "-o", "h.csv"]);
    assert_eq!((code, told_of.as_str()), (Some(0), "h.csv: 2 rows, 4 columns\n"));
    let table = Table::read(&folder.join("h.csv")).expect("a table");
    assert_eq!(table.headings[3], "uz at (0.1; 0.1; 0.1) (m)");
    let (code, _) = told(folder, &["extremes", "-o", "e.csv"]);
    assert_eq!(code, Some(0));
    let table = Table::read(&folder.join("e.csv")).expect("a table");
    assert_eq!(table.headings.len(), 1 + 6 * 2 * 4);

    for (words, expected_code, message) in [
        (
            &["history", "--point", "0.1,0.1"][..],
            1,
            "results are of bodies in space; expected X,Y,Z",
        ),
        (&["history", "--nearest", "1,2,3,4"], 2, "expected X,Y in the plane or X,Y,Z in space"),
        (&["history", "--point", "7,7,7"], 1, "no tetrahedron holds the point (7; 7; 7)"),
        (&["line", "--from", "0,0", "--to", "1,1"], 1, "the point 0,0 has 2 coordinates"),
        (&["extremes", "--fields", "smax"], 1, "bodies in space have no field smax; expected von-"),
        (
            &["force-displacement", "--support", "box:,:0.01", "--moved", "all"],
            1,
            "the selection box::,:0.01 does not fit results of bodies in space; \
             expected box:X0:X1,Y0:Y1,Z0:Z1",
        ),
        (&["top-line"], 1, "the top line is one of bodies in the plane"),
        (&["top-line"], 1, "use `line` from X,Y,Z to X,Y,Z, or `history` at nodes"),
        (&["arch", "--centre", "0,0", "--radius", "1"], 1, "use `line` from X,Y,Z to X,Y,Z"),
        (&["arch", "--centre", "0,0,0", "--radius", "1"], 2, "in space there is --what line"),
    ] {
        let (code, told) = told(folder, words);
        assert_eq!(code, Some(expected_code), "{words:?}: {told}");
        assert!(told.contains(message), "{words:?}: {told}");
        assert_eq!(told.lines().count(), 1, "{told}");
    }
    let (code, _, told) = ypsilon(folder, &["plot", "plate.pvd", "-o", "x.png"]);
    assert_eq!(code, Some(1));
    assert!(told.contains("bodies in space, expected bodies in the plane"), "{told}");
    let mut results = Results::open(folder).expect("results");
    let fault = top_line(&mut results, None, &[FrameChoice::Last]).expect_err("a fault");
    assert!(matches!(fault, PostError::Nothing(_)));
}
