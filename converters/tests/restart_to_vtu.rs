//! Decks of the classic dialect to grids.

mod vtu_decoder;

use std::fs;
use std::path::{Path, PathBuf};

use vtu_decoder::{Vtu, decode};
use ypsilon_converters::restart::restart_to_vtu;

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../yformat/tests/data/classic").join(name)
}

fn read(path: &Path) -> Vtu {
    decode(&fs::read(path).unwrap())
}

#[test]
fn a_restart_deck_becomes_triangles_and_joints() {
    let folder = tempfile::tempdir().unwrap();
    let report = restart_to_vtu(&data("g_joint_pair4_restart.y"), folder.path(), "pair").unwrap();
    let [bodies, joints] = &report.grids[..] else { panic!("{:?}", report.grids) };
    assert_eq!(joints, &folder.path().join("pair_joints.vtu"));
    let codes: Vec<_> = report.diagnostics.iter().map(|found| found.code).collect();
    assert_eq!(codes, ["deck::restart-masses"]);

    let bodies = read(bodies);
    assert_eq!(bodies.attributes["NumberOfPoints"], "10");
    assert_eq!(bodies.array("Cells", "connectivity").values, [4.0, 5.0, 6.0, 7.0, 8.0, 9.0]);
    assert_eq!(bodies.array("CellData", "material property ID").values, [0.0, 0.0]);
    let masses = &bodies.array("PointData", "nodal mass").values;
    assert_eq!(masses[3..5], [0.0, 4.166666666666667]);
    // Points move by what the displacement says, from the initial coordinates of the deck.
    let points = &bodies.array("Points", "Points").values;
    let displacement = &bodies.array("PointData", "displacement").values;
    let initial = [0.1, 0.0, 0.0];
    for axis in 0..3 {
        let moved = initial[axis] + displacement[15 + axis];
        assert!((points[15 + axis] - moved).abs() < 1e-16);
    }

    let joints = read(joints);
    // four boundaries and one joint with two walls
    assert_eq!(joints.array("Cells", "types").values, [3.0; 6]);
    let kinds = &joints.array("CellData", "kind").values;
    assert_eq!(kinds.iter().filter(|&&kind| kind == 1.0).count(), 4);
    let elements = &joints.array("CellData", "element").values;
    assert_eq!(elements[..], [2.0, 3.0, 4.0, 4.0, 5.0, 6.0]);
    let roughness = &joints.array("CellData", "roughness coefficient").values;
    assert_eq!(roughness[..], [0.0, 0.0, 15.0, 15.0, 0.0, 0.0]);
    assert_eq!(joints.array("FieldData", "TimeValue").values.len(), 1);
}

#[test]
fn an_ordinary_deck_has_triangles_only() {
    let folder = tempfile::tempdir().unwrap();
    let report = restart_to_vtu(&data("g_joint_pair.y"), folder.path(), "pair").unwrap();
    assert_eq!(report.grids, [folder.path().join("pair.vtu")]);
    assert_eq!(read(&report.grids[0]).attributes["NumberOfCells"], "2");
}

#[test]
fn undefined_states_are_shown_as_such() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(data("g_joint_pair4_restart.y")).unwrap();
    let at = text.find("D1JAPH     5\n").unwrap() + "D1JAPH     5\n".len();
    let mut text = text.into_bytes();
    text[at..at + 28].copy_from_slice(b"                        -nan");
    let deck = folder.path().join("a_restart.y");
    fs::write(&deck, text).unwrap();
    let report = restart_to_vtu(&deck, folder.path(), "a").unwrap();
    let joints = read(&report.grids[1]);
    assert!(joints.array("CellData", "hydraulic aperture").values[0].is_nan());
    assert!(report.diagnostics.iter().any(|found| found.code == "deck::undefined-state"));
}

#[test]
fn what_cannot_be_shown_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(data("g_joint_pair4_restart.y")).unwrap();
    let deck = folder.path().join("a.y");
    fs::write(&deck, text.replace("     7      8      9     -1", "     7      8     99     -1"))
        .unwrap();
    let error = restart_to_vtu(&deck, folder.path(), "a").unwrap_err().to_string();
    assert_eq!(error, "element 1 names node 99, but there are 10, counted from 0");
    fs::write(&deck, "/YD/YDPE/MPROP 1\n").unwrap();
    let error = restart_to_vtu(&deck, folder.path(), "a").unwrap_err().to_string();
    assert!(error.contains("a.y:1:1: error[deck::unknown-database]"), "{error}");
    assert!(!folder.path().join("a.vtu").exists());
}

/// Every shared deck of the classic dialect, where they are there.
#[test]
fn shared_decks_of_the_classic_dialect_are_converted() {
    let shared = match std::env::var_os("YPSILON_SHARED") {
        Some(folder) => PathBuf::from(folder),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared"),
    };
    let mut folders: Vec<PathBuf> =
        ["thirdparty/acse/decks", "thirdparty/acse/test"].map(|part| shared.join(part)).to_vec();
    for part in ["reference/classic", "thirdparty/reference/classic"] {
        let runs = fs::read_dir(shared.join(part)).into_iter().flatten();
        folders.extend(runs.map(|run| run.unwrap().path()));
    }
    let output = tempfile::tempdir().unwrap();
    let mut decks = 0;
    for entry in folders.iter().flat_map(|folder| fs::read_dir(folder).into_iter().flatten()) {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "y") {
            continue;
        }
        let report = restart_to_vtu(&path, output.path(), "a");
        let report = report.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        for grid in &report.grids {
            assert!(read(grid).attributes["NumberOfCells"] != "0", "{}", path.display());
        }
        decks += 1;
    }
    match decks {
        0 => println!("skipped: no classic decks under {}", shared.display()),
        _ => println!("{decks} shared decks are converted"),
    }
}
