//! The same as `warns_of_doubtful_decks.rs` for the classic dialect.
//!
//! The decks are `bad_decks/base_classic_glued.y` with the replacements listed here.

mod support;

use insta::assert_snapshot;
use std::fmt::Write;
use support::spoilt_deck::{Edits, base_of, edit, verdict};
use yformat::diagnostic::Severity;

/// What is said about each deck. All must have exactly one finding, and run.
fn one_finding_each(severity: Severity, cases: &[(&str, Edits<'_>)]) -> String {
    let (mut said, mut wrong) = (String::new(), String::new());
    for (doubt, edits) in cases {
        let found = verdict(edit(base_of("classic_glued"), edits).as_bytes());
        let as_wanted = found.severities == [severity] && found.placed == [true] && found.runs;
        let list = if as_wanted { &mut said } else { &mut wrong };
        let _ = writeln!(list, "== {doubt}\n{}", found.text);
    }
    assert_eq!(wrong, "", "not one {severity} with a place:\n{wrong}");
    said
}

#[test]
fn values_that_the_original_takes_from_anywhere() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("no settling time", &[("/YD/YDC/DCGRST 0\n", "")]),
            ("no duration of the rise", &[("/YD/YDC/DCRMPT 0\n", "")]),
            ("no scale of stresses", &[("/YD/YDC/DCSIZS 1e8\n", "")]),
            ("no scale of displacements", &[("/YD/YDC/DCSIZD 0.1\n", "")]),
            ("no scale of apertures", &[("/YD/YDC/DCSIZA 1e-7\n", "")]),
            ("scale of 0", &[("DCSIZC 10", "DCSIZC 0")]),
            ("scale without logarithm", &[("DCSIZA 1e-7", "DCSIZA 1")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn sets_of_the_wrong_kind() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("triangle of a joint set", &[("I1ELPR 2 0 0", "I1ELPR 2 0 1")]),
            ("node of a set of triangles", &[("I1NOPR 4 2 3 2 3", "I1NOPR 4 0 3 2 3")]),
            ("node of a set that does not exist", &[("I1NOPR 4 2 3 2 3", "I1NOPR 4 -1 3 2 3")]),
            ("mesh code of a joint set", &[("I1PEMN 4 3 0", "I1PEMN 4 3 3")]),
            ("mesh code with digits that do nothing", &[("I1PEMN 4 3", "I1PEMN 4 73")]),
            (
                "several joint sets",
                &[
                    ("MPROP 4", "MPROP 5"),
                    ("NPROP 4", "NPROP 5"),
                    ("I1PTYP 4 1 3 -1 -1", "I1PTYP 5 1 3 -1 -1 3"),
                    ("D1PEFT 4 0 1e6 0 0", "D1PEFT 5 0 1e6 0 0 1e6"),
                    ("D1PEGT 4 0 2 0 0", "D1PEGT 5 0 2 0 0 2"),
                    ("D1PEGS 4 0 8 0 0", "D1PEGS 5 0 8 0 0 8"),
                    ("D1PEPE 4 0 1e11 0 0", "D1PEPE 5 0 1e11 0 0 1e11"),
                    ("D1PCOH 4 0 2e6 0 0", "D1PCOH 5 0 2e6 0 0 2e6"),
                    ("D1PICF 4 0 0.6 0 0", "D1PICF 5 0 0.6 0 0 0.6"),
                    ("D1PEFR 4 0.5 0.5 0 0", "D1PEFR 5 0.5 0.5 0 0 0.5"),
                ],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn loads_and_contact_that_do_nothing() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("code of Y-Geo", &[("I1PNFX 4 0 0 3 1", "I1PNFX 4 0 0 3 4")]),
            (
                "pressure with a factor of 0",
                &[
                    ("D1PNAP 4 0 0 0 0", "D1PNAP 4 0 0 0 1e5"),
                    ("D1PNAF 4 0 0 1 1", "D1PNAF 4 0 0 1 0"),
                ],
            ),
            (
                "traction without factor",
                &[("D1PNAT 4 0 0 0 0", "D1PNAT 4 0 0 0 1e5"), ("/YD/YDP/D1PNAF 4 0 0 1 1\n", "")],
            ),
            ("axes that are no unit vectors", &[("D1PNXX 4 0 0 1 1", "D1PNXX 4 0 0 1 2")]),
            (
                "no boundary nodes",
                &[("I1NOBF 4 1 1 1 1", "I1NOBF 4 0 0 0 0"), ("I1PEMN 4 3", "I1PEMN 4 0")],
            ),
            ("no contact penalty", &[("/YD/YDP/D1PEPC 4 1e11 0 0 0\n", "")]),
            ("late detection", &[("DIEDI 200", "DIEDI 0")]),
            ("clockwise triangle", &[("0 3 2\n", "0 2 3\n"), ("I1PEMN 4 3", "I1PEMN 4 0")]),
            ("no step to do", &[("MCSTEP 20", "MCSTEP 0")]),
            (
                "time step longer than a wave takes",
                &[("DCSTEC 1e-6", "DCSTEC 1e-3"), ("D1PNAX 4 0 0 0 5e3", "D1PNAX 4 0 0 0 0")],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn slips_of_the_original() {
    let said = one_finding_each(
        Severity::Warning,
        &[("codes along z", &[("/YD/YDP/I1PNFX", "/YD/YDP/I1PNFZ 4 0 0 0 0\n/YD/YDP/I1PNFX")])],
    );
    assert_snapshot!(said);
}

#[test]
fn what_is_worth_knowing() {
    let said = one_finding_each(
        Severity::Note,
        &[
            (
                "no current coordinates",
                &[("/YD/YDN/D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n0.0 1.0\n1.0 1.0\n", "")],
            ),
            ("history that is never updated", &[("I1OHYT 1 15", "I1OHYT 1 1")]),
            ("no room for couples", &[("MICOUP 40", "MICOUP 0")]),
            ("separation alone", &[("I1PEMN 4 3", "I1PEMN 4 4")]),
        ],
    );
    assert_snapshot!(said);
}

/// Real decks leave what a kind of set does not use at 0 or out.
#[test]
fn what_is_harmless_is_not_mentioned() {
    for edits in [
        &[("/YD/YDP/D1PSEM 4 0 0 0 0\n", "")],
        &[("D1PELA 4 2.8e9 0 0 0", "D1PELA 1 2.8e9")],
        &[("D1PEFT 4 0 1e6 0 0", "D1PEFT 2 0 1e6")],
        &[("D1PNAF 4 0 0 1 1", "D1PNAF 4 0 0 0 0")],
        &[("/YD/YDP/D1PNAF 4 0 0 1 1\n", "")],
        &[("I1PNFX 4 0 0 3 1", "I1PNFX 4 7 7 3 1")],
        &[("D1PJRC 4 0 15 0 0", "D1PJRC 0")],
    ] {
        let found = verdict(edit(base_of("classic_glued"), edits).as_bytes());
        assert_eq!(found.text, "", "{edits:?}");
        assert!(found.runs);
    }
}
