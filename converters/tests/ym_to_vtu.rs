//! `.ym` snapshots to `.vtu` series.

mod vtu_decoder;

use std::fs;
use std::path::Path;

use vtu_decoder::Vtu;
use yformat::ym::{
    AcousticSource, BoundaryJoint, Digits, FractureJoint, MeanVelocity, Record, Scales,
    SnapshotWriter, Triangle,
};
use ypsilon_converters::ym::{SnapshotTimes, YmNotice, YmSeries, ym_to_vtu};

const SCALES: Scales = Scales {
    coordinate: 10.0,
    force: 1e6,
    stress: 1e8,
    velocity: 100.0,
    displacement: 0.1,
    aperture: 1e-7,
};

const DECK: &str = "/YD/YDC/MCSTEP 100 /YD/YDC/DCSIZC 10 /YD/YDC/DCSIZF 1e6 /YD/YDC/DCSIZS 1e8
/YD/YDC/DCSIZV 100 /YD/YDC/DCSIZD 0.1 /YD/YDC/DCSIZA 1e-7 /YD/YDC/DCSTEC 0.5 /YD/YDC/ICOUTF 4
/YD/YDC/ICOUTP 6 $YDOIT\n";

fn digits() -> Digits {
    Digits::new(6).unwrap()
}

fn triangle(stress: [f64; 3], contact_force: Option<[f64; 2]>) -> Record {
    Record::Triangle(Triangle {
        corners: [[1.0, 1.0], [2.0, 1.0], [1.0, 3.0]],
        velocity: MeanVelocity::of_corners([[1.0, 2.0], [2.0, 4.0], [3.0, 9.0]]),
        stress,
        damage: 0.25,
        contact_force,
    })
}

fn fracture() -> Record {
    Record::FractureJoint(FractureJoint {
        nodes: [[1.0, 1.0], [2.0, 1.0], [2.0, 1.5], [1.0, 1.5]],
        failure_mode: 1.5,
        normal_stress: 2e6,
        shear_stress: -3e6,
        sliding_force: 4e5,
        aperture: 1e-4,
        shear_displacement: 0.03,
        dilation: -0.02,
        hydraulic_aperture: 1e-5,
    })
}

fn boundary() -> Record {
    Record::BoundaryJoint(BoundaryJoint {
        nodes: [[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [0.0, 0.0]],
        contact_force: [2e5, -1e5],
    })
}

fn source() -> Record {
    Record::AcousticSource(AcousticSource { position: [5.0, 6.0], magnitude: -2.5 })
}

fn write(path: &Path, records: &[Record]) {
    let mut writer = SnapshotWriter::new(Vec::new(), digits(), SCALES).unwrap();
    records.iter().for_each(|record| writer.write(record).unwrap());
    fs::write(path, writer.into_inner()).unwrap();
}

/// Three snapshots of a run with two sets of joints; a crack appears in the last one.
fn write_series(folder: &Path) {
    let pull = triangle([3e6, 1e6, 0.0], Some([1e5, -2e5]));
    let soft = triangle([-4e6, -4e6, 0.0], None);
    let early = [pull, soft, boundary(), boundary()];
    write(&folder.join("wall0.ym"), &early);
    write(&folder.join("wall2.ym"), &early);
    let late = [fracture(), boundary(), source()];
    write(&folder.join("wall10.ym"), &[&[pull, soft][..], &late, &late].concat());
    fs::write(folder.join("wall.y"), DECK).unwrap();
}

fn decoded(folder: &Path, name: &str) -> Vtu {
    vtu_decoder::decode(&fs::read(folder.join(name)).unwrap())
}

/// Values agree to two quanta of their scale.
fn assert_close(vtu: &Vtu, name: &str, expected: &[f64], scale: f64) {
    let found = &vtu.array("CellData", name).values;
    assert_eq!(found.len(), expected.len(), "{name}");
    let tolerance = 2.0 * digits().quantum() * scale;
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{name}: {found} {expected}");
    }
}

#[test]
fn a_series_becomes_grids_and_a_collection() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    let mut told = Vec::new();
    let report = ym_to_vtu(&folder.join("wall2.ym"), None, folder, "out", |done, all| {
        told.push((done, all))
    })
    .unwrap();
    assert_eq!(told, [(1, 3), (2, 3), (3, 3)]);
    assert_eq!((report.snapshots, report.grids, report.notices.len()), (3, 7, 0));
    assert_eq!(report.deck, Some(folder.join("wall.y")));
    insta::assert_snapshot!(fs::read_to_string(report.collection).unwrap());
    let mut names: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.starts_with("out"))
        .collect();
    names.sort();
    let expected = [
        "out.pvd",
        "out_0.vtu",
        "out_10.vtu",
        "out_2.vtu",
        "out_acoustic_10.vtu",
        "out_cracks_0.vtu",
        "out_cracks_10.vtu",
        "out_cracks_2.vtu",
    ];
    assert_eq!(names, expected);
}

#[test]
fn triangles_have_their_values() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    ym_to_vtu(&folder.join("wall0.ym"), None, folder, "out", |_, _| {}).unwrap();
    let vtu = decoded(folder, "out_10.vtu");
    assert_eq!(vtu.array("Cells", "types").values, [5.0, 5.0]);
    assert_eq!(vtu.array("Cells", "connectivity").values, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(vtu.array("FieldData", "TimeValue").values, [20.5]);
    let points = &vtu.array("Points", "Points").values;
    let corner = [1.0, 3.0, 0.0];
    for axis in 0..3 {
        assert!((points[6 + axis] - corner[axis]).abs() <= 2.0 * digits().quantum() * 10.0);
    }
    assert_close(&vtu, "velocity", &[2.0, 5.0, 0.0, 2.0, 5.0, 0.0], 100.0);
    let stress = [3e6, 1e6, 0.0, 0.0, 0.0, 0.0, -4e6, -4e6, 0.0, 0.0, 0.0, 0.0];
    assert_close(&vtu, "Cauchy stress", &stress, 1e8);
    assert_close(&vtu, "sigma1 (compression positive)", &[-1e6, 4e6], 1e8);
    assert_close(&vtu, "sigma3 (compression positive)", &[-3e6, 4e6], 1e8);
    assert_close(&vtu, "mean stress (compression positive)", &[-2e6, 4e6], 1e8);
    assert_close(&vtu, "differential stress", &[2e6, 0.0], 1e8);
    // In tension everywhere the largest compression is the 0 out of plane, and conversely.
    let sigma1 = &vtu.array("CellData", "sigma1 vector (compression positive)").values;
    assert_eq!(sigma1[..3], [0.0; 3]);
    let length = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    assert!((length(&sigma1[3..]) - 4e6).abs() < 1e3);
    let sigma3 = &vtu.array("CellData", "sigma3 vector (compression positive)").values;
    assert!((sigma3[0].abs() - 3e6).abs() < 1e3 && sigma3[1].abs() < 1e3, "{sigma3:?}");
    assert_eq!(sigma3[3..], [0.0; 3]);
    assert_close(&vtu, "contact force", &[1e5, -2e5, 0.0, 0.0, 0.0, 0.0], 1e6);
    assert_close(&vtu, "damage", &[0.25, 0.25], 1.0);
}

#[test]
fn cracks_and_sources_appear_once() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    ym_to_vtu(&folder.join("wall0.ym"), None, folder, "out", |_, _| {}).unwrap();
    // Two equal boundaries of two sets are one.
    assert_eq!(decoded(folder, "out_cracks_0.vtu").attributes["NumberOfCells"], "1");
    let vtu = decoded(folder, "out_cracks_10.vtu");
    assert_eq!(vtu.array("Cells", "types").values, [3.0; 3]);
    assert_eq!(vtu.array("CellData", "fracture type").values, [1.0, 1.0, -1.0]);
    assert_close(&vtu, "failure mode", &[1.5, 1.5, -1.0], 2.0);
    assert_close(&vtu, "shear displacement", &[0.03, 0.03, 0.0], 0.1);
    assert_close(&vtu, "dilation", &[-0.02, -0.02, 0.0], 0.1);
    // 0.2 of the scale, times 0.05
    assert_close(&vtu, "legacy shear displacement", &[0.01, 0.01, 0.0], 0.05);
    assert_close(&vtu, "normal stress (compression positive)", &[2e6, 2e6, 0.0], 1e8);
    assert_close(&vtu, "shear stress", &[-3e6, -3e6, 0.0], 1e8);
    assert_close(&vtu, "sliding force", &[4e5, 4e5, 0.0], 1e6);
    // 16 = ln(1e7): a quantum of the logarithm
    assert_close(&vtu, "aperture", &[1e-4, 1e-4, 0.0], 16.2 * 1e-4);
    assert_close(&vtu, "hydraulic aperture", &[1e-5, 1e-5, 0.0], 16.2 * 1e-5);
    let force = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2e5, -1e5, 0.0];
    assert_close(&vtu, "contact force", &force, 1e6);
    let points = &vtu.array("Points", "Points").values;
    for (found, expected) in points.iter().zip([
        1.0, 1.0, 0.0, 2.0, 1.0, 0.0, 2.0, 1.5, 0.0, 1.0, 1.5, 0.0, 0.0, 0.0, 0.0, 4.0, 0.0, 0.0,
    ]) {
        assert!((found - expected).abs() <= 2.0 * digits().quantum() * 10.0);
    }
    let sources = decoded(folder, "out_acoustic_10.vtu");
    assert_eq!(sources.array("Cells", "types").values, [1.0]);
    assert_close(&sources, "magnitude", &[-2.5], 15.0);
}

#[test]
fn without_a_deck_values_are_relative_and_a_notice_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    fs::rename(folder.join("wall.y"), folder.join("other.y")).unwrap();
    let input = folder.join("wall10.ym");
    let report = ym_to_vtu(&input, None, folder, "out", |_, _| {}).unwrap();
    assert_eq!(report.notices, [YmNotice::NoDeck { expected: folder.join("wall.y") }]);
    assert!(report.notices[0].to_string().contains("--deck"));
    let vtu = decoded(folder, "out_10.vtu");
    assert_close(&vtu, "damage", &[0.25, 0.25], 1.0);
    assert_close(&vtu, "velocity", &[0.02, 0.05, 0.0, 0.02, 0.05, 0.0], 1.0);
    assert_eq!(vtu.array("FieldData", "TimeValue").values, [10.0]);
    // named, it is used
    let other = folder.join("other.y");
    let report = ym_to_vtu(&input, Some(&other), folder, "out", |_, _| {}).unwrap();
    assert_eq!((report.deck, report.notices), (Some(other), vec![]));
    assert_close(
        &decoded(folder, "out_10.vtu"),
        "velocity",
        &[2.0, 5.0, 0.0, 2.0, 5.0, 0.0],
        100.0,
    );
    // a restart deck will do
    fs::rename(folder.join("other.y"), folder.join("wall10_restart.y")).unwrap();
    let report = ym_to_vtu(&input, None, folder, "out", |_, _| {}).unwrap();
    assert_eq!(report.deck, Some(folder.join("wall10_restart.y")));
}

#[test]
fn what_the_deck_leaves_open_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    let deck = "/YD/YDC/DCSIZS 1e8 /YD/YDC/DCSIZV 0 /YD/YDC/ICOUTF 0 /YD/YDC/FOO\n";
    fs::write(folder.join("wall.y"), deck).unwrap();
    let mut text = fs::read(folder.join("wall10.ym")).unwrap();
    text.truncate(text.len() - 3);
    fs::write(folder.join("wall10.ym"), text).unwrap();
    let report = ym_to_vtu(&folder.join("wall0.ym"), None, folder, "out", |_, _| {}).unwrap();
    let told: Vec<String> = report.notices.iter().map(ToString::to_string).collect();
    for (told, part) in told.iter().zip([
        "wall.y:1:54: error[deck::unknown-keyword]",
        "no DCSIZD",
        "no DCSIZA",
        "DCSIZV is 0",
        "ICOUTF",
        "wall10.ym:9: the last line is cut",
    ]) {
        assert!(told.contains(part), "{told} / {part}");
    }
    assert_eq!(told.len(), 6, "{told:?}");
    assert_eq!(decoded(folder, "out_2.vtu").array("FieldData", "TimeValue").values, [2.0]);
}

#[test]
fn damaged_snapshots_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    write_series(folder);
    fs::write(folder.join("wall2.ym"), "CODED\nx\n").unwrap();
    let error = ym_to_vtu(&folder.join("wall0.ym"), None, folder, "out", |_, _| {}).unwrap_err();
    assert!(error.to_string().contains("wall2.ym:2: the line `x`"), "{error}");
    assert!(!folder.join("out.pvd").exists());
    let error = ym_to_vtu(&folder.join("wall.ym"), None, folder, "out", |_, _| {}).unwrap_err();
    assert!(error.to_string().contains("is not called like a snapshot"), "{error}");
}

#[test]
fn series_are_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let touch = |name: &str| fs::write(folder.join(name), "").unwrap();
    let numbers = |input: &str, deck: Option<&str>| {
        let deck = deck.map(|deck| folder.join(deck));
        let series = YmSeries::find(&folder.join(input), deck.as_deref()).unwrap();
        let numbers: Vec<u64> = series.snapshots.iter().map(|(number, _)| *number).collect();
        (series.prefix, numbers, series.notices.len())
    };
    for name in ["rock40.ym", "rock41.ym", "rock410.ym", "rock05.ym", "other1.ym", "rock4x.ym"] {
        touch(name);
    }
    // no deck: the longest number, and a notice that there is none
    assert_eq!(numbers("rock40.ym", None), ("rock".into(), vec![40, 41, 410], 1));
    touch("rock4.y");
    assert_eq!(numbers("rock40.ym", None), ("rock4".into(), vec![0, 1, 10], 0));
    touch("rock.dry.y");
    assert_eq!(numbers("rock40.ym", None), ("rock".into(), vec![40, 41, 410], 1));
    assert_eq!(numbers("rock40.ym", Some("rock4.y")), ("rock4".into(), vec![0, 1, 10], 0));
    assert_eq!(numbers("rock40.ym", Some("rock.dry.y")), ("rock".into(), vec![40, 41, 410], 0));
}

/// The rule, in the numbers of shared reference runs: `ICOUTF` 500 and restart at step 2000.
#[test]
fn times_follow_the_steps_at_whose_end_snapshots_are_written() {
    let times = |first_step, first_time, first_number| SnapshotTimes {
        first_step,
        first_time,
        time_step: 2e-6,
        interval: 500,
        first_number,
    };
    let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-15, "{a} {b}");
    close(times(0, 0.0, 0).time(0), 2e-6);
    close(times(0, 0.0, 0).time(3), 1501.0 * 2e-6);
    // A restart deck says the same about the snapshots before it and goes on after it.
    close(times(2000, 0.004, 4).time(3), 1501.0 * 2e-6);
    close(times(2000, 0.004, 4).time(4), 2001.0 * 2e-6);
    // A run that begins between two multiples writes at the next one.
    close(times(501, 501.0 * 2e-6, 7).time(7), 1001.0 * 2e-6);
}

/// A run of the original: triangles of the snapshot that the repository keeps.
#[test]
fn a_snapshot_of_the_original_is_converted() {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../yformat/tests/data/classic");
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let report =
        ym_to_vtu(&data.join("g_joint_pair4.ym"), None, folder, "pair", |_, _| {}).unwrap();
    assert_eq!((report.snapshots, report.notices), (2, vec![]));
    let cracks = decoded(folder, "pair_cracks_4.vtu");
    // one fracture with two walls, four boundaries
    assert_eq!(cracks.attributes["NumberOfCells"], "6");
    let kinds = &cracks.array("CellData", "fracture type").values;
    assert_eq!(kinds[2..], [-1.0; 4]);
    assert_eq!(decoded(folder, "pair_4.vtu").attributes["NumberOfCells"], "2");
}

/// Every shared run of the original, where they are there.
#[test]
fn shared_runs_of_the_original_are_converted() {
    let shared = match std::env::var_os("YPSILON_SHARED") {
        Some(folder) => std::path::PathBuf::from(folder),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared"),
    };
    let mut runs = 0;
    for part in ["reference/classic", "thirdparty/reference/classic"] {
        for run in fs::read_dir(shared.join(part)).into_iter().flatten() {
            let run = run.unwrap().path();
            let case = run.file_name().unwrap().to_str().unwrap().to_owned();
            let snapshots = fs::read_dir(&run)
                .unwrap()
                .filter(|entry| {
                    let name = entry.as_ref().unwrap().file_name();
                    name.to_str().unwrap().ends_with(".ym")
                })
                .count();
            let folder = tempfile::tempdir().unwrap();
            let first = run.join(format!("{case}0.ym"));
            let report = ym_to_vtu(&first, None, folder.path(), &case, |_, _| {}).unwrap();
            assert_eq!((report.snapshots, report.notices), (snapshots, vec![]), "{case}");
            assert_eq!(report.deck, Some(run.join(format!("{case}.y"))));
            for entry in fs::read_dir(folder.path()).unwrap() {
                let path = entry.unwrap().path();
                if path.extension().is_some_and(|extension| extension == "vtu") {
                    let vtu = vtu_decoder::decode(&fs::read(&path).unwrap());
                    let finite =
                        vtu.arrays.iter().all(|a| a.values.iter().all(|value| value.is_finite()));
                    assert!(finite, "{}", path.display());
                }
            }
            runs += 1;
        }
    }
    match runs {
        0 => println!("skipped: no runs of the classic program under {}", shared.display()),
        _ => println!("{runs} shared runs are converted"),
    }
}
