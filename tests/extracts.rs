//! `ypsilon extract` and the monitors against values computed by hand.

#[path = "extracts/space.rs"]
mod space;
mod support;

use assert_cmd::Command;
use std::path::Path;
use support::{
    plate_deck::{CELLS, Case, LOAD, SIDE, displacement, node, plate},
    results::results,
};
use ypsilon_post::{
    Point,
    extract::{
        self, Place, along, energy, extremes, force_displacement, histories, joint_counts, top_line,
    },
    field::Field,
    results::{FrameChoice, Results},
    selection::Selection,
    table::Table,
};

const LAMBDA: f64 = 4e8;
const MU: f64 = 4e8;

/// Cauchy stress xx, yy, xy and strain energy per area of the linear displacement.
fn by_hand() -> ([f64; 3], f64) {
    let f = [[1.002, 0.001], [0.0, 0.997]];
    let j = f[0][0] * f[1][1];
    let b = |i: usize, k: usize| f[i][0] * f[k][0] + f[i][1] * f[k][1];
    let volumetric = 0.5 * LAMBDA * (j - 1.0 / j);
    let stress = [
        MU / j * (b(0, 0) - 1.0) + volumetric,
        MU / j * (b(1, 1) - 1.0) + volumetric,
        MU / j * b(0, 1),
    ];
    let shear = 0.5 * MU * (b(0, 0) + b(1, 1) - 2.0 - 2.0 * j.ln());
    (stress, shear + 0.5 * LAMBDA * (0.5 * (j * j - 1.0) - j.ln()))
}

fn near(found: f64, expected: f64, relative: f64, what: &str) {
    let allowed = relative * expected.abs();
    assert!((found - expected).abs() <= allowed, "{what}: {found}, expected {expected}");
}

fn value(table: &Table, row: usize, name: &str) -> f64 {
    let column = table.find(name).unwrap_or_else(|error| panic!("{error}"));
    table.column(column)[row]
}

fn selection(words: &str) -> Selection {
    words.parse().expect("a selection")
}

#[test]
fn a_linear_displacement_has_constant_stress_and_straight_lines() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &["e=all:strain-energy"], 1);
    let mut vtu = Results::open(&folder.path().join("plate.pvd")).expect("a series");
    let ([xx, yy, xy], density) = by_hand();

    let path = extract::Path::Line([Point::Plane([0.01, 0.02]), Point::Plane([0.39, 0.37])]);
    let fields = [Field::StressXx, Field::StressYy, Field::StressXy, Field::DisplacementX];
    let line = along(&mut vtu, &path, 50, &fields, &[FrameChoice::Last]).expect("a table");
    assert_eq!(line.rows.len(), 50);
    for (row, cells) in line.rows.iter().enumerate() {
        near(value(&line, row, "sxx"), xx, 1e-9, "σxx");
        near(value(&line, row, "syy"), yy, 1e-9, "σyy");
        near(value(&line, row, "sxy"), xy, 1e-9, "σxy");
        let [ux, _] = displacement(cells[2], cells[3]);
        assert!((value(&line, row, "ux") - ux).abs() < 1e-15);
    }
    near(line.rows[49][1], 0.38_f64.hypot(0.35), 1e-14, "length");

    let top = top_line(&mut vtu, None, &[FrameChoice::Index(0)]).expect("a table");
    assert_eq!(top.rows.len(), CELLS + 1);
    for row in &top.rows {
        let [ux, uy] = displacement(row[2], SIDE);
        assert!((row[4] - ux).abs() < 1e-15 && (row[5] - uy).abs() < 1e-15, "{row:?}");
    }

    // the stress acts on the deformed upper edge: its horizontal normal has the deformed length
    let upper = force_displacement(&mut vtu, &selection("box:,0.39:"), &selection("all"));
    let upper = upper.expect("a table");
    near(value(&upper, 0, "reaction y"), yy * 1.002 * SIDE, 1e-9, "reaction y");

    let monitored = Table::read(&folder.path().join("plate.monitors.csv")).expect("a table");
    assert_eq!(monitored.rows.len(), 2);
    near(monitored.rows[0][2], density * SIDE * SIDE, 1e-6, "strain energy");
}

#[test]
fn reactions_carry_the_load() {
    let monitors = [
        "feet=box:,:0.001:reaction-x,reaction-y,contact-y",
        "sets=nodes:0,1,2,3,4:reaction-y,uy",
        "top=line:0,0.4,0.4,0.4:ux,uy,umax",
        "all=material:0:kinetic-energy,broken-joints,force-y",
    ];
    let folder = results(&plate(Case::Loaded, 60_001), &monitors, 12_000);
    let mut vtu = Results::open(folder.path()).expect("a folder with one collection");
    let feet = selection("box:,:0.001");
    let pushed = force_displacement(&mut vtu, &feet, &selection("set:2")).expect("a table");
    let last = pushed.rows.len() - 1;
    assert_eq!(pushed.rows.len(), 2);
    near(value(&pushed, last, "reaction y"), LOAD, 1e-6, "reaction");
    let sideways = value(&pushed, last, "reaction x");
    assert!(sideways.abs() < 1e-6 * LOAD, "reaction x: {sideways}");

    // σyy = −p and σxx = 0 everywhere
    let path = extract::Path::Line([Point::Plane([0.05, 0.21]), Point::Plane([0.39, 0.21])]);
    let fields = [Field::StressYy, Field::StressXx, Field::VonMisesInPlane];
    let line = along(&mut vtu, &path, 20, &fields, &[FrameChoice::Last]).expect("a table");
    let pressure = LOAD / SIDE;
    for row in 0..20 {
        near(value(&line, row, "syy"), -pressure, 1e-3, "σyy");
        assert!(value(&line, row, "sxx").abs() < 1e-3 * pressure);
        near(value(&line, row, "von-mises-plane"), pressure, 1e-3, "von Mises");
    }

    let extreme = extremes(&mut vtu, &[Field::DisplacementY]).expect("a table");
    let least = value(&extreme, last, "min uy");
    let place = value(&extreme, last, "y of min uy");
    assert!(least < 0.0 && (place - SIDE - least).abs() < 1e-12, "{least} at {place}");
    let places = [Place::Node(node(2, CELLS)), Place::Point(Point::Plane([0.2, SIDE]))];
    let history = histories(&mut vtu, &places, &[Field::DisplacementY]).expect("a table");
    assert_eq!(history.rows[last][1], history.rows[last][2]);
    near(history.rows[last][1], value(&pushed, last, "mean displacement uy"), 1e-3, "top");

    let monitored = Table::read(&folder.path().join("plate.monitors.csv")).expect("a table");
    assert_eq!(monitored.rows.len(), 6);
    let end = monitored.rows.len() - 1;
    near(value(&monitored, end, "feet reaction-y"), LOAD, 1e-6, "monitored reaction");
    assert_eq!(value(&monitored, end, "feet contact-y"), 0.0);
    let same = ["feet reaction-y", "sets reaction-y"].map(|name| value(&monitored, end, name));
    assert_eq!(same[0], same[1]);
    // step 60000 is in both: the same sums
    assert_eq!(value(&monitored, end, "feet reaction-y"), value(&pushed, last, "reaction y"));
    assert!(value(&monitored, end, "all force-y").abs() < 1e-9 * LOAD);
    assert!(value(&monitored, end, "top umax") >= -value(&monitored, end, "top uy"));
    assert_eq!(value(&monitored, end, "all broken-joints"), 0.0);

    let energies = energy(&mut vtu).expect("a table");
    assert_eq!(energies.rows[last][1], value(&monitored, end, "all kinetic-energy"));
    assert!(joint_counts(&mut vtu).is_err(), "the plate has no joints");
}

#[test]
fn d3plot_families_tell_the_same_in_single_precision() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let mut family = Results::open(&folder.path().join("plate")).expect("a family");
    let ([xx, ..], _) = by_hand();
    let path = extract::Path::Line([Point::Plane([0.0, 0.1]), Point::Plane([0.4, 0.1])]);
    let fields = [Field::StressXx, Field::Displacement];
    let line = along(&mut family, &path, 9, &fields, &[FrameChoice::Last]).expect("a table");
    for row in 0..9 {
        near(value(&line, row, "sxx"), xx, 1e-6, "σxx");
    }
    let fault = force_displacement(&mut family, &selection("all"), &selection("all"));
    let fault = fault.expect_err("a family has no forces").to_string();
    assert!(fault.contains("no nodal forces"), "{fault}");
}

/// Exit code and messages of the program.
fn ypsilon(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    let output = command.current_dir(folder).args(arguments).output().expect("the program starts");
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn the_command_writes_tables_and_tells_what_is_wrong() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let run = |words: &[&str]| {
        let mut arguments = vec!["extract", "plate.pvd", "--what"];
        arguments.extend(words);
        ypsilon(folder.path(), &arguments)
    };
    let (code, _, told) = run(&["history", "--node", "0", "-o", "history.csv"]);
    assert_eq!((code, told.as_str()), (Some(0), "history.csv: 2 rows, 3 columns\n"));
    let table = Table::read(&folder.path().join("history.csv")).expect("a table");
    assert_eq!(table.headings, ["time (s)", "ux at node 0 (m)", "uy at node 0 (m)"]);
    let (code, printed, _) = run(&["energy"]);
    assert_eq!((code, printed.lines().next()), (Some(0), Some("time (s),kinetic energy (J)")));

    for (words, expected_code, message) in [
        (&["history"][..], 2, "it needs --node N, --point X,Y[,Z] or --nearest X,Y[,Z]"),
        (&["history", "--node", "99"], 1, "nodes run from 0 to 24"),
        (&["history", "--point", "7,7"], 1, "no triangle holds the point (7; 7)"),
        (&["line", "--from", "0,0"], 2, "it needs --to"),
        (&["line", "--from", "5,5", "--to", "6,6"], 1, "the path lies in no body"),
        (&["line", "--from", "0", "--to", "1,1"], 2, "expected X,Y in the plane or X,Y,Z in"),
        (&["arch", "--centre", "0,0", "--radius", "1", "--angles", "9"], 2, "expected LOW:HIGH"),
        (&["extremes", "--fields", "stress"], 2, "the field `stress`: there are von-mises"),
        (&["top-line", "--times", "#7"], 1, "states are #0 to #1"),
        (&["top-line", "--times", "noon"], 2, "expected a time in s"),
        (&["joints"], 1, "no joints at any time"),
        (&["force-displacement", "--support", "set:9", "--moved", "all"], 1, "holds no node"),
        (&["history", "--node", "0", "--fields", "uz"], 1, "no field uz; expected u, ux, uy"),
        (&["history", "--point", "0,0,0"], 1, "results are of bodies in the plane; expected X,Y"),
        (
            &["force-displacement", "--support", "box:,,:1", "--moved", "all"],
            1,
            "does not fit results of bodies in the plane; expected box:X0:X1,Y0:Y1",
        ),
        (&["energy", "-o", "nowhere/table.csv"], 3, "nowhere/table.csv"),
    ] {
        let (code, _, told) = run(words);
        assert_eq!(code, Some(expected_code), "{words:?}: {told}");
        assert!(told.contains(message), "{words:?}: {told}");
    }
    let (code, _, told) = ypsilon(folder.path(), &["extract", "plate.y", "--what", "energy"]);
    assert_eq!(code, Some(1));
    assert!(told.contains("expected a .pvd collection"), "{told}");
}

#[test]
fn monitors_that_watch_nothing_are_refused() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let run = |monitor: &str| {
        let arguments = ["run", "plate.y", "--out", "again", "-q", "--monitor", monitor];
        let (code, _, told) = ypsilon(folder.path(), &arguments);
        (code, told)
    };
    let (code, told) = run("far=box:7:8,:ux");
    assert_eq!(code, Some(2), "{told}");
    assert!(told.contains("monitor far: the selection box:7:8,: holds no node"), "{told}");
    let (code, told) = run("x=all:speed");
    assert_eq!(code, Some(2));
    assert!(told.contains("quantities are reaction-x"), "{told}");
}
