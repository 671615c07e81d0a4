//! Decks of the classic and Y-Geo dialects, converted to the split dialect and run, against the
//! states of their own programs; decks of the split dialect, converted to another dialect and back.

mod support;

use std::{collections::BTreeMap, fs, path::Path};

use support::state_file::StateFile;
use tempfile::TempDir;
use yformat::{deck::Deck, dialect::Dialect};
use ypsilon_converters::dialects::convert_deck;

/// x y vx vy of each node.
type Nodes = Vec<[f64; 4]>;

fn data() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}

/// Nodes of a state of the classic or Y-Geo program.
fn original(path: &Path) -> Nodes {
    let text = fs::read_to_string(path).expect("a reference state");
    let lines = text.lines().filter_map(|line| line.strip_prefix("N "));
    lines
        .map(|line| {
            let words: Vec<f64> = line.split(' ').map(|w| w.parse().expect("a number")).collect();
            [words[1], words[2], words[3], words[4]]
        })
        .collect()
}

/// Runs a deck and gives its states.
fn run(text: &str, steps: &[u64]) -> BTreeMap<u64, StateFile> {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = folder.path().join("deck.y");
    fs::write(&deck, text).expect("the deck is written");
    let list: Vec<String> = steps.iter().map(u64::to_string).collect();
    let last = steps.iter().max().expect("a step").to_string();
    let output = assert_cmd::Command::new(env!("CARGO_BIN_EXE_ypsilon"))
        .current_dir(folder.path())
        .args(["run", "deck.y", "--formats", "json", "--quiet", "--states", &list.join(",")])
        .args(["--steps", &last])
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let state = |&step: &u64| {
        let path = folder.path().join(format!("deck.state_{step}.txt"));
        (step, StateFile::read(&path).expect("a state"))
    };
    steps.iter().map(state).collect()
}

fn read(path: &Path) -> Deck {
    Deck::read(path).expect("a deck").deck
}

/// Largest differences of coordinates and velocities, relative to the largest value.
fn differences(ours: &StateFile, original: &Nodes) -> [f64; 2] {
    assert_eq!(ours.nodes.len(), original.len());
    [0..2, 2..4].map(|columns| {
        let (mut difference, mut largest) = (0.0_f64, 0.0_f64);
        for (ours, original) in ours.nodes.iter().zip(original) {
            for column in columns.clone() {
                difference = difference.max((ours[column] - original[column]).abs());
                largest = largest.max(original[column].abs());
            }
        }
        difference / largest
    })
}

fn compare(dialect: &str, name: &str, steps: &[u64], tolerance: f64) {
    let folder = data().join("converted").join(dialect).join(name);
    let deck = read(&folder.join(format!("{name}.y")));
    let converted = convert_deck(&deck, Dialect::Split).expect("the deck can be converted");
    let states = run(&converted.deck.to_text(), steps);
    for (step, ours) in states {
        let original = original(&folder.join(format!("state_{step}.txt")));
        let found = differences(&ours, &original);
        assert!(
            found.iter().all(|&difference| difference <= tolerance),
            "{dialect} {name}, step {step}: {found:?}"
        );
    }
}

#[test]
fn classic_decks_compute_the_same_in_the_split_dialect() {
    // D1PELA acts twice in the classic dialect: with twice the value the bits are the same.
    compare("classic", "b_elastic_damped", &[1, 1000], 0.0);
    compare("classic", "h_bc_types", &[1000], 0.0);
    // The ramp is a table here: the factor is rounded otherwise.
    compare("classic", "h_bc_ramp", &[1, 1000, 2000], 1e-11);
    // Contact forces are summed in another order.
    compare("classic", "d_slide_friction", &[1000], 1e-15);
}

#[test]
fn ygeo_decks_compute_the_same_in_the_split_dialect() {
    for (name, steps) in [
        ("c_contact_normal", &[10, 1000][..]),
        ("g_joint_pair", &[10, 1000]),
        ("h_bc_ramp", &[1000]),
        ("i_pressure", &[1000]),
    ] {
        compare("ygeo", name, steps, 0.0);
    }
}

#[test]
fn decks_come_back_unchanged_from_the_ygeo_dialect() {
    let mut compared = 0;
    for entry in fs::read_dir(data().join("split2d")).expect("reference cases") {
        let folder = entry.expect("a case").path();
        let name = folder.file_name().expect("a name").to_string_lossy().into_owned();
        let deck = read(&folder.join(format!("{name}.y")));
        let there = convert_deck(&deck, Dialect::YGeo).expect("to Y-Geo");
        let ygeo = Deck::parse("ygeo.y", there.deck.to_text());
        assert!(!ygeo.diagnostics.iter().any(|finding| finding.is_error()), "{name}");
        assert_eq!(ygeo.deck.dialect(), Dialect::YGeo, "{name}");
        let back = convert_deck(&ygeo.deck, Dialect::Split).expect("and back");
        // Flags other than 1 become 0, which is what they mean.
        if !there.lost.is_empty() || name == "c_nobf_two" {
            continue;
        }
        assert_eq!(back.lost, [""; 0], "{name}");
        let steps = &[1];
        let text = deck.to_text();
        assert_eq!(run(&text, steps), run(&back.deck.to_text(), steps), "{name}");
        compared += 1;
    }
    assert!(compared > 50, "{compared} decks were compared");
}
