//! Whatever a result file holds: its conversion ends without panic, and what it leaves are whole
//! files only.

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use ypsilon_converters::d3plot::{DeletedElements, d3plot_to_vtu};
use ypsilon_converters::history::histories_to_csv;
use ypsilon_converters::restart::restart_to_vtu;
use ypsilon_converters::ym::ym_to_vtu;

/// Most bytes that the files of such a conversion may have.
const LARGEST: u64 = 50 << 20;

fn sample(path: &str) -> Vec<u8> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    fs::read(root.join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// A file cut short, or with some bytes replaced.
fn spoilt(bytes: Vec<u8>) -> impl Strategy<Value = Vec<u8>> {
    let changes = prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..8);
    (Just(bytes), changes, any::<prop::sample::Index>(), any::<bool>()).prop_map(
        |(mut bytes, changes, length, is_cut)| {
            for (place, byte) in changes {
                let place = place.index(bytes.len());
                bytes[place] = byte;
            }
            if is_cut {
                bytes.truncate(length.index(bytes.len()));
            }
            bytes
        },
    )
}

/// Converts a file of these bytes in a folder of its own and looks at what is left.
fn exercise(name: &str, bytes: &[u8], convert: impl FnOnce(&Path, &Path)) {
    let folder = tempfile::tempdir().expect("a folder");
    let input: PathBuf = folder.path().join(name);
    fs::write(&input, bytes).expect("writable");
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("writable");
    convert(&input, &out);
    let mut size = 0;
    for entry in fs::read_dir(out).expect("readable").flatten() {
        let path = entry.path();
        assert_ne!(path.extension().unwrap_or_default(), "part", "{}", path.display());
        if path.extension().is_some_and(|e| e == "vtu") {
            let text = fs::read(&path).expect("readable");
            assert!(text.trim_ascii_end().ends_with(b"</VTKFile>"), "{}", path.display());
        }
        size += entry.metadata().map_or(0, |m| m.len());
    }
    assert!(size <= LARGEST, "{size} bytes");
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn d3plot_families(bytes in spoilt(sample("tests/data/split2d/x_mesh_31/x_mesh_31.d3plot"))) {
        exercise("family", &bytes, |input, out| {
            let _ = d3plot_to_vtu(input, out, "family", DeletedElements::Flag, |_, _| {});
        });
    }

    #[test]
    fn snapshots(bytes in spoilt(sample("tests/data/classic/e_joint_tension/e_joint_tension4.ym"))) {
        exercise("run4.ym", &bytes, |input, out| {
            let _ = ym_to_vtu(input, None, out, "run", |_, _| {});
        });
    }

    #[test]
    fn histories(bytes in spoilt(sample("tests/data/classic/g_joint_pair/g_joint_pair.yh0"))) {
        exercise("run.yh0", &bytes, |input, out| {
            let _ = histories_to_csv(&[input], &out.join("run.csv"));
        });
    }

    #[test]
    fn restart_decks(
        bytes in spoilt(sample("tests/data/classic/g_joint_pair/g_joint_pair4_restart.y")),
    ) {
        exercise("run.y", &bytes, |input, out| {
            let _ = restart_to_vtu(input, out, "run");
        });
    }
}
