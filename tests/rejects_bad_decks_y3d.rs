//! What `.Y3D` decks ask for that is not simulated, and mistakes that only they can have: one
//! finding each, at the right place, with what was expected there and how to mend it.

mod support;

use insta::assert_snapshot;
use std::{collections::BTreeSet, fs, path::Path};
use support::spoilt_deck::all_say;
use yformat::{
    diagnostic::Severity,
    dialect::Dialect,
    keywords::{Role, find, reference, tables},
};

fn deck(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/y3d");
    fs::read_to_string(folder.join(name)).expect("a committed deck")
}

#[test]
fn the_decks_are_sound() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/y3d");
    for entry in fs::read_dir(folder).expect("the decks").flatten() {
        let path = entry.path();
        if path.extension().is_some_and(|e| e == "Y3D") {
            let found = support::spoilt_deck::verdict_of(&path);
            // keywords without effect are noted
            let fine = found.severities.iter().all(|severity| *severity == Severity::Note);
            assert!(found.runs && fine, "{path:?}: {}", found.text);
        }
    }
}

#[test]
fn what_is_not_simulated() {
    let said = all_say(
        Severity::Error,
        &deck("12_joint_pair.Y3D"),
        &[
            ("harmonic velocity", &[("I1BNVZ 3\n0 1 1", "I1BNVZ 3\n0 1 2")]),
            ("rigid bodies", &[("$YDOIT", "/YD/YSP/MSPD 1 /YD/YSP/NSPD 1\n$YDOIT")]),
            ("thermal expansion", &[("$YDOIT", "/YD/YDP/D1CTEX 2 1e-5 0\n$YDOIT")]),
            ("convection", &[("$YDOIT", "/YD/YDB/I1BCVT 3 0 1 0\n$YDOIT")]),
            ("mass scaling", &[("$YDOIT", "/YD/YDP/D1PEMR 2 0.5 0\n$YDOIT")]),
            ("weak joints", &[("$YDOIT", "/YD/YDJ/DEFECT 0.1\n$YDOIT")]),
            ("chip removal", &[("DCRMPT 0.0", "DCRMPT 0.0\n/YD/YDC/ICHPRM 1")]),
            ("staged load", &[("DCRMPT 0.0", "DCRMPT 0.0\n/YD/YDC/DCRMCT 1")]),
            ("mesh code", &[("I1PEMN 2\n3 0", "I1PEMN 2\n13 0")]),
            ("softening tetrahedra", &[("I1PTYP 2\n13 15", "I1PTYP 2\n14 15")]),
            ("code of another branch", &[("I1PTYP 2\n13 15", "I1PTYP 2\n21 15")]),
            ("couples of an earlier run", &[("IIECFF -2", "IIECFF 0")]),
            ("a second stage", &[("$YDOIT", "$YDOIT\n/YD/YDC/MCSTEP 70000\n$YDOIT")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn mistakes() {
    let said = all_say(
        Severity::Error,
        &deck("12_joint_pair.Y3D"),
        &[
            (
                "numbered from 1",
                &[("     0      2      1      4      1", "     0      2      1      5      1")],
            ),
            (
                "no body numbers",
                &[(
                    "I2ELTO 21 5 2\n     0      1      2      3      1\n     0      2      1      4      1",
                    "I2ELTO 21 4 2\n     0      1      2      3\n     0      2      1      4",
                )],
            ),
            ("boundary set", &[("0 0 0 1 2", "0 0 0 1 3")]),
            ("property set", &[("I1ELPR 2\n0 0", "I1ELPR 2\n0 2")]),
            ("element of joints", &[("I1ELPR 2\n0 0", "I1ELPR 2\n0 1")]),
            ("no joints", &[("I1PEJP 2\n1 0", "I1PEJP 2\n0 0")]),
            (
                "no cohesion",
                &[(
                    "D1PCOH 2\n+3.00000000000e+06 +3.00000000000e+06",
                    "D1PCOH 2\n+3.00000000000e+06 0",
                )],
            ),
            ("no room for joints", &[("MELEM 21", "MELEM 4")]),
            (
                "pressure inside",
                &[
                    ("     2      1      4\n", "     0      1      2\n"),
                    ("0.0 0.0 0.0 0.0 0.0 0.0", "0.0 0.0 0.0 5.0 0.0 0.0"),
                ],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn ten_node_tetrahedra() {
    let deck = deck("11_one_tet10.Y3D").replace("D1PEPSF 1\n+1", "D1PEPSF 1\n+0");
    let said = all_say(
        Severity::Error,
        &deck,
        &[
            ("consistent masses", &[("INITER 0", "INITER 2")]),
            ("pressure", &[("0.0 0.0 0.0 0.0\n", "0.0 1.0 0.0 0.0\n")]),
            ("joints", &[("I1PEMN 1\n0", "I1PEMN 1\n3")]),
            (
                "order of the nodes",
                &[("4      5      6      7      8      9", "9      8      7      6      5      4")],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn what_runs_otherwise_than_written() {
    let said = all_say(
        Severity::Warning,
        &deck("12_joint_pair.Y3D"),
        &[
            (
                "inside out",
                &[("     0      2      1      4      1", "     0      1      2      4      1")],
            ),
            ("consistent masses", &[("INITER 0", "INITER 2")]),
            ("late detection", &[("DIEZON +0.00000000000e+00", "DIEZON 300")]),
        ],
    );
    assert_snapshot!(said);
}

/// Sources that read `.Y3D` decks only, and those that read all decks of tetrahedra.
const READERS: [&str; 2] = ["src/scene/from_deck/y3d", "src/scene/from_deck"];

/// The keywords that the sources of a folder name, as `YDC/MCSTEP`.
fn named_in(folder: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(folder).expect("the sources").flatten() {
        let path = entry.path();
        let is_source = path.extension().is_some_and(|ending| ending == "rs");
        let text = if is_source { fs::read_to_string(path) } else { Ok(String::new()) };
        let text = text.expect("a source");
        let words = text.split("\"Y").skip(1).filter_map(|rest| rest.split('"').next());
        let is_name = |word: &&str| {
            let is_letter = |c: char| c == '/' || c.is_ascii_uppercase() || c.is_ascii_digit();
            word.matches('/').count() == 1 && word.chars().all(is_letter)
        };
        names.extend(words.filter(is_name).map(|word| format!("Y{word}")));
    }
    names
}

#[test]
fn the_reference_tells_which_keywords_are_taken() {
    let reference = reference(Dialect::Y3d, None);
    let own = named_in(READERS[0]);
    assert!(own.len() > 40, "{own:?}");
    for name in &own {
        let keyword = find(Dialect::Y3d, name).unwrap_or_else(|| panic!("{name} is unknown"));
        let is_taken = matches!(keyword.role, Role::Required | Role::Used);
        assert!(is_taken, "{name} is taken, but said to be {:?}", keyword.role);
        let section = format!("## {}\n", keyword.database);
        let rows = reference.split(&section).nth(1).and_then(|rest| rest.split("\n## ").next());
        let row = format!("| {} |", keyword.name);
        assert!(rows.is_some_and(|rows| rows.contains(&row)), "the reference lacks {name}");
    }
    // what is said to have an effect is asked for, or sizes arrays
    let taken: BTreeSet<String> = READERS.iter().flat_map(|folder| named_in(folder)).collect();
    for keyword in tables(Dialect::Y3d).iter().flat_map(|table| table.keywords) {
        let name = format!("{}/{}", keyword.database, keyword.name);
        let sizes = tables(Dialect::Y3d).iter().flat_map(|table| table.keywords);
        let mut sizes = sizes.filter(|other| other.database == keyword.database);
        let is_size = sizes.any(|other| other.is_sized_by(keyword.name));
        assert!(
            keyword.role != Role::Used || is_size || taken.contains(&name),
            "{name} is said to be used and never asked for"
        );
    }
}

/// Every keyword that is said to be refused is.
#[test]
fn what_the_reference_calls_refused_is_refused() {
    let deck = deck("12_joint_pair.Y3D");
    let mut refused = 0;
    for keyword in tables(Dialect::Y3d).iter().flat_map(|table| table.keywords) {
        let Role::Refused(what) = keyword.role else { continue };
        let value = ["1", "1 1", "21 3 1 1 1 1"][keyword.rank()];
        let size = match keyword.database {
            "YSP" => "/YD/YSP/MSPD 1",
            "YDX" => "/YD/YDX/NELNO 3 /YD/YDX/NELEM 1",
            _ => "",
        };
        let asks = format!("{size} {} {value}\n$YDOIT", keyword.path());
        let name = format!("{}/{}", keyword.database, keyword.name);
        let said = all_say(Severity::Error, &deck, &[(&name, &[("$YDOIT", &asks)])]);
        let message = format!("{name} asks for what is not simulated: {what}");
        assert!(said.contains(&message), "{said}");
        refused += 1;
    }
    assert!(refused >= 15, "{refused}");
}
