//! Whatever the inputs of the converters hold: conversion ends without panic, and leaves complete
//! results or none.

mod vtu_decoder;

use proptest::prelude::*;
use std::{fs, path::Path};
use tempfile::TempDir;
use vtu_decoder::{Vtu, decode};
use yformat::dialect::Dialect;
use ypsilon_converters::{
    d3plot::{DeletedElements, d3plot_to_vtu},
    detect::detect_file,
    dialects::deck_to_dialect,
    history::histories_to_csv,
    restart::restart_to_vtu,
    ym::ym_to_vtu,
};

/// Most bytes that the files of such a conversion may have.
const LARGEST: u64 = 50 << 20;

/// A converter with sound inputs.
struct Converter {
    /// What the input is called.
    input: &'static str,
    /// Sound inputs, small ones.
    seeds: &'static [&'static [u8]],
    /// Converts the first file to files in the second folder; whether it could.
    convert: fn(&Path, &Path) -> bool,
}

const CONVERTERS: [Converter; 5] = [
    Converter {
        input: "run.d3plot",
        seeds: &[
            include_bytes!("../../yformat/tests/data/d3plot/a_gravxy.d3plot"),
            include_bytes!("../../yformat/tests/data/d3plot/jx_33_2.d3plot"),
            include_bytes!("../../yformat/tests/data/d3plot/t3d_uniaxial.d3plot"),
            include_bytes!("../../yformat/tests/data/d3plot/x_mesh_31.d3plot"),
        ],
        convert: |input, folder| {
            [DeletedElements::Drop, DeletedElements::Flag]
                .map(|deleted| d3plot_to_vtu(input, folder, "run", deleted, |_, _| ()).is_ok())[0]
        },
    },
    Converter {
        input: "run4.ym",
        seeds: &[
            include_bytes!("../../yformat/tests/data/classic/g_joint_pair4.ym"),
            include_bytes!("../../yformat/tests/data/classic/f_joint_shear4.ym"),
        ],
        convert: |input, folder| ym_to_vtu(input, None, folder, "run", |_, _| ()).is_ok(),
    },
    Converter {
        input: "run.yh0",
        seeds: &[
            b"0.0000000000e+00   1.0000000000e+00\n1.0000000000e-03  -2.5000000000e-01\n",
            b"+0.00000e+00 +1.00000e+00\n +1.0e+00 -2.0e+00\n+1.00000e-03 +2.00000e+00\n +0.0e+00 +0.0e+00\n",
        ],
        convert: |input, folder| histories_to_csv(&[input], &folder.join("run.csv")).is_ok(),
    },
    Converter {
        input: "run4_restart.y",
        seeds: &[
            include_bytes!("../../yformat/tests/data/classic/g_joint_pair4_restart.y"),
            include_bytes!("../../yformat/tests/data/classic/g_joint_pair.y"),
        ],
        convert: |input, folder| restart_to_vtu(input, folder, "run").is_ok(),
    },
    Converter {
        input: "deck.y",
        seeds: &[
            include_bytes!("../../yformat/tests/data/classic/g_joint_pair.y"),
            include_bytes!("../../tests/bad_decks/base.y"),
            include_bytes!("../../tests/bad_decks/base_ygeo.y"),
        ],
        convert: |input, folder| {
            let to = [Dialect::Split, Dialect::Classic, Dialect::YGeo];
            let made = to.map(|to| deck_to_dialect(input, &folder.join(format!("{to}.y")), to));
            made.iter().any(Result::is_ok)
        },
    },
];

/// Converts bytes in an empty folder; whether that was possible. Results must be complete, and
/// none may be left by failures.
fn exercise(converter: &Converter, bytes: &[u8]) -> bool {
    let folder = TempDir::new().expect("a temporary folder");
    let input = folder.path().join(converter.input);
    fs::write(&input, bytes).expect("a writable folder");
    let _ = detect_file(&input);
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("a writable folder");
    let could = (converter.convert)(&input, &out);
    let (mut files, mut size) = (0, 0);
    for entry in fs::read_dir(&out).expect("a folder").flatten() {
        size += entry.metadata().map_or(0, |metadata| metadata.len());
        assert!(size <= LARGEST, "{size} bytes");
        check_complete(&entry.path());
        files += 1;
    }
    assert_eq!(files > 0, could, "{files} files, but success is {could}");
    could
}

/// Whether a result file is whole.
fn check_complete(path: &Path) {
    let bytes = fs::read(path).expect("a result");
    let extension = path.extension().and_then(|extension| extension.to_str());
    match extension {
        Some("vtu") => check_grid(&decode(&bytes)),
        Some("pvd") => {
            let text = String::from_utf8(bytes).expect("text");
            assert!(text.trim_end().ends_with("</VTKFile>"), "{text}");
            for file in text.split("file=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
                assert!(path.with_file_name(file).is_file(), "{file} is missing");
            }
        }
        Some("csv" | "y") => assert!(bytes.ends_with(b"\n")),
        _ => panic!("{} is left behind", path.display()),
    }
}

/// Whether each point and each cell has its values.
fn check_grid(grid: &Vtu) {
    let count = |name: &str| grid.attributes[name].parse::<usize>().expect("a number");
    let (points, cells) = (count("NumberOfPoints"), count("NumberOfCells"));
    let of_points = &grid.array("Points", "Points").values;
    assert_eq!(of_points.len(), 3 * points);
    assert_eq!(grid.array("Cells", "types").values.len(), cells);
    let nodes = &grid.array("Cells", "connectivity").values;
    assert!(nodes.iter().all(|&node| (0.0..points as f64).contains(&node)));
    for array in &grid.arrays {
        let rows = match array.section.as_str() {
            "PointData" => points,
            "CellData" => cells,
            _ => continue,
        };
        let components = array.attributes.get("NumberOfComponents").map_or("1", String::as_str);
        let wanted = rows * components.parse::<usize>().expect("a number");
        assert_eq!(array.values.len(), wanted, "{}", array.attributes["Name"]);
    }
}

#[test]
fn sound_inputs_are_converted() {
    for converter in &CONVERTERS {
        for (index, seed) in converter.seeds.iter().enumerate() {
            assert!(exercise(converter, seed), "{} {index}", converter.input);
        }
    }
}

/// A later snapshot that is damaged spoils the series; nothing of it may stay.
#[test]
fn a_damaged_snapshot_leaves_no_grids_of_those_before_it() {
    let folder = TempDir::new().expect("a temporary folder");
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("a writable folder");
    let first = folder.path().join("run0.ym");
    fs::write(&first, CONVERTERS[1].seeds[0]).expect("a writable folder");
    fs::write(folder.path().join("run1.ym"), b"CODED\nwhat?\n").expect("a writable folder");
    assert!(ym_to_vtu(&first, None, &out, "run", |_, _| ()).is_err());
    assert_eq!(fs::read_dir(&out).expect("a folder").count(), 0);
}

/// Numbers that stand for counts and sizes in the binary files.
fn hostile_word() -> impl Strategy<Value = [u8; 4]> {
    prop_oneof![
        any::<[u8; 4]>(),
        prop::sample::select(vec![0_i32, 1, -1, 2, 3, 4, 6, 9, 70, 1000, i32::MAX, i32::MIN])
            .prop_map(i32::to_le_bytes),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn truncated_inputs(
        which in 0..CONVERTERS.len(),
        seed in any::<prop::sample::Index>(),
        length in any::<prop::sample::Index>(),
    ) {
        let converter = &CONVERTERS[which];
        let bytes = converter.seeds[seed.index(converter.seeds.len())];
        exercise(converter, &bytes[..length.index(bytes.len() + 1)]);
    }

    #[test]
    fn inputs_with_other_bytes(
        which in 0..CONVERTERS.len(),
        seed in any::<prop::sample::Index>(),
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), prop_oneof![any::<u8>(), Just(b'9'), Just(b' '), Just(b'-')]),
            1..6,
        ),
    ) {
        let converter = &CONVERTERS[which];
        let mut bytes = converter.seeds[seed.index(converter.seeds.len())].to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        exercise(converter, &bytes);
    }

    #[test]
    fn families_with_other_words(
        seed in 0..4_usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), hostile_word(), any::<bool>()), 1..4),
    ) {
        let mut bytes = CONVERTERS[0].seeds[seed].to_vec();
        for (at, word, in_header) in changes {
            let words = if in_header { 64 } else { bytes.len() / 4 };
            let at = 4 * at.index(words);
            bytes[at..at + 4].copy_from_slice(&word);
        }
        exercise(&CONVERTERS[0], &bytes);
    }

    #[test]
    fn decks_with_other_words(
        which in 3..5_usize,
        seed in any::<prop::sample::Index>(),
        changes in prop::collection::vec(
            (
                any::<prop::sample::Index>(),
                prop::sample::select(vec![
                    "0", "-1", "3", "7", "1e300", "nan", "99999999999", "/*", "*/", "$YDOIT", "$YINCL",
                    "/YD/YDE/NELEM", "/YD/YDN/NNOPO", "/YD/YDJ/NJOINT", "/YD/YDP/I1PTYP",
                ]),
            ),
            1..4,
        ),
    ) {
        let converter = &CONVERTERS[which];
        let text = String::from_utf8_lossy(converter.seeds[seed.index(converter.seeds.len())]).into_owned();
        let mut words: Vec<&str> = text.split_inclusive(char::is_whitespace).collect();
        for (at, word) in changes {
            let at = at.index(words.len());
            words[at] = word;
            words.insert(at + 1, " ");
        }
        exercise(converter, words.concat().as_bytes());
    }

    #[test]
    fn random_bytes(which in 0..CONVERTERS.len(), bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        exercise(&CONVERTERS[which], &bytes);
    }
}
