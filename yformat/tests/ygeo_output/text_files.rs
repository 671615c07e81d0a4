//! The text files, parsed and written again.

use yformat::history::History;
use yformat::ygeo_output::{
    BreakageRecord, HydrofracturePoint, RestartFragment, TextFile, YieldMode, YieldRecord,
    write_history_point,
};

use super::reference::{cases, committed};

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

fn numbers(words: &[&str]) -> Vec<f64> {
    words.iter().map(|word| word.parse().unwrap()).collect()
}

#[test]
fn histories_come_back_byte_for_byte() {
    let mut files = 0;
    for case in cases().into_iter().chain(committed()) {
        let Some(original) = case.text(&TextFile::History(0).path(&case.deck())) else {
            continue;
        };
        let mut ours = Vec::new();
        for point in History::parse(original.as_bytes()).unwrap().points {
            write_history_point(&mut ours, point.time, point.value).unwrap();
        }
        assert_eq!(text(ours), original, "{}", case.name);
        files += 1;
    }
    assert!(files > 0);
}

#[test]
fn records_of_broken_joints_come_back_byte_for_byte() {
    let mut lines = 0;
    for case in cases().into_iter().chain(committed()) {
        let path = TextFile::Breakage.path(&case.deck());
        for line in case.text(&path).iter().flat_map(|original| original.lines()) {
            let words: Vec<&str> = line.split('\t').collect();
            let [element, reals @ .., "", _window_start] = &words[..] else {
                panic!("{}: {line}", path.display());
            };
            let r = numbers(reals);
            let record = BreakageRecord {
                element: element.trim().parse().unwrap(),
                failure_mode: r[0],
                time: r[1],
                centroid: [r[2], r[3]],
                edge: [[r[4], r[5]], [r[6], r[7]]],
                fracture_energy: r[8],
                length: -r[8] / r[9],
                kinetic_energy_change: r[10],
                peak_time: r[11],
                fracture_network: None,
            };
            let mut ours = Vec::new();
            record.write(&mut ours).unwrap();
            assert_eq!(text(ours), format!("{line}\n"), "{}", path.display());
            let edge = (r[4] - r[6]).hypot(r[5] - r[7]);
            assert!((record.length / edge - 1.0).abs() < 3e-3, "{}: {line}", path.display());
            lines += 1;
        }
    }
    println!("{lines} broken joints");
    assert!(lines > 0);
}

#[test]
fn records_of_yielded_joints_come_back_byte_for_byte() {
    let mut lines = 0;
    for case in cases().into_iter().chain(committed()) {
        let path = TextFile::Yielding.path(&case.deck());
        for line in case.text(&path).iter().flat_map(|original| original.lines()) {
            let words: Vec<&str> = line.split('\t').collect();
            let r = numbers(&words[2..]);
            let record = YieldRecord {
                element: words[0].trim().parse().unwrap(),
                mode: match words[1] {
                    "1" => YieldMode::Opening,
                    "2" => YieldMode::Sliding,
                    "3" => YieldMode::Mixed,
                    other => panic!("{}: mode {other}", path.display()),
                },
                time: r[0],
                centroid: [r[1], r[2]],
                edge: [[r[3], r[4]], [r[5], r[6]]],
            };
            let mut ours = Vec::new();
            record.write(&mut ours).unwrap();
            assert_eq!(text(ours), format!("{line}\n"), "{}", path.display());
            lines += 1;
        }
    }
    println!("{lines} yielded joints");
    assert!(lines > 0);
}

/// The original's files have none of these; what follows is outputs.md, 5.7.
#[test]
fn formats_without_reference_files_are_as_specified() {
    let record = BreakageRecord {
        element: 123,
        failure_mode: 5.0,
        time: 1e-3,
        centroid: [0.5, 0.5],
        edge: [[0.0, 0.0], [1.0, 1.0]],
        fracture_energy: -2.0,
        length: 4.0,
        kinetic_energy_change: 0.25,
        peak_time: 8e-4,
        fracture_network: Some(3),
    };
    let mut ours = Vec::new();
    record.write(&mut ours).unwrap();
    assert!(text(ours).ends_with("\t+5.000e-01\t+2.500e-01\t+8.000e-04\t    3\t+8.000e-04\n"));

    let mut ours = Vec::new();
    let point = HydrofracturePoint { time: 0.5, pressure: 1e6, mass: 2.0, volume: 0.002 };
    point.write(&mut ours).unwrap();
    assert_eq!(text(ours), "+5.000e-01\t+1.000e+06\t+2.000e+00\t0.002000\n");

    let mut ours = Vec::new();
    let fragment = RestartFragment {
        step: 99,
        time: 0.25,
        coordinates: &[[0.0, 1.0], [0.5, -0.25]],
        velocities: &[[0.0, 0.0], [1e-3, 2.0]],
    };
    fragment.write(&mut ours).unwrap();
    let expected = "/* Current restart data stored for \nTime Step: 99 @ Time: 0.250000 */ \n\n\
        /YD/YDN/D2NCC 21 2 2 \n0.000000 \t 1.000000 \n0.500000 \t -0.250000 \n\n\
        /YD/YDN/D2NVC 21 2 2 \n0.000000 \t 0.000000 \n0.001000 \t 2.000000 \n";
    assert_eq!(text(ours), expected);
}
