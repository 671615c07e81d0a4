//! What `.Y3D` decks ask for that is not simulated, and mistakes that only they can have: one
//! finding each, at the right place, with what was expected there and how to mend it.

mod support;

use insta::assert_snapshot;
use std::{fs, path::Path};
use support::spoilt_deck::all_say;
use yformat::diagnostic::Severity;

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
