//! What is allowed but probably not meant gives one warning, what is merely worth knowing one note;
//! the deck runs all the same, as it does with the original.
//!
//! The decks are `bad_decks/base.y` with the replacements listed here.

mod support;

use insta::assert_snapshot;
use std::fmt::Write;
use support::spoilt_deck::{Edits, edited, verdict};
use yformat::diagnostic::Severity;

/// What is said about each deck. All must have exactly one finding, and run.
fn one_finding_each(severity: Severity, cases: &[(&str, Edits<'_>)]) -> String {
    let (mut said, mut wrong) = (String::new(), String::new());
    for (doubt, edits) in cases {
        let found = verdict(edited(edits).as_bytes());
        let as_wanted = found.severities == [severity] && found.placed == [true] && found.runs;
        let list = if as_wanted { &mut said } else { &mut wrong };
        let _ = writeln!(list, "== {doubt}\n{}", found.text);
    }
    assert_eq!(wrong, "", "not one {severity} with a place:\n{wrong}");
    said
}

#[test]
fn values_that_are_read_in_another_way_than_meant() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("fewer values than announced", &[("D1PNAX 2 0 5e3", "D1PNAX 2 5e3")]),
            ("keyword without value", &[("/YD/YDC/ICOUTF 10", "/YD/YDC/ICOUTF 10 /YD/YDC/DCTIME")]),
            ("keyword with a longer name", &[("/YD/YDC/ICOUTF 10", "/YD/YDC/ICOUTFREQ 10")]),
            ("count glued to the keyword", &[("/YD/YDN/I1NOBF 4 1", "/YD/YDN/I1NOBF4 4 1")]),
            ("sign apart from its number", &[("DCGRAY -9.81", "DCGRAY -9.81 /YD/YDC/DCTIME -\n")]),
            ("exponent without digits", &[("D1PELA 1 1e9", "D1PELA 1 1e")]),
            ("order code that is none", &[("I2ELTO 21 3 2", "I2ELTO 31 3 2")]),
            (
                "comment that swallows keywords",
                &[("/YD/YDC/DCGRAY -9.81", "/* gravity*/\n/YD/YDC/DCGRAY -9.81 /* m/s2 */")],
            ),
            ("last word without line end", &[("$YSTOP\n", "/YD/YDC/MCSTEP")]),
            (
                "size keyword that comes again",
                &[
                    ("/YD/YDI/MICOUP 40", "/YD/YDI/MICOUP 40\n/YD/YDPE/MPROP 1"),
                    ("/YD/YDPE/D1PEKS 1 1e4\n", ""),
                    (
                        "/YD/YDPE/MPROP 1\n/YD/YDPE/NPROP",
                        "/YD/YDPE/D1PEKS 1 1e4\n/YD/YDPE/MPROP 1\n/YD/YDPE/NPROP",
                    ),
                ],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn control_values_with_surprises() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("no steps", &[("/YD/YDC/MCSTEP 20\n", "")]),
            ("gravity along x", &[("DCGRAY -9.81", "DCGRAY -9.81 /YD/YDC/DCGRAX 9.81")]),
            (
                "time step longer than a wave takes",
                &[("DCSTEC 1e-5", "DCSTEC 2e-3"), ("D1PNAX 2 0 5e3", "D1PNAX 2 0 0")],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn meshing_that_does_not_do_what_it_seems_to() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("digit without meaning", &[("21 3 1\n1 3 0\n", "21 3 1\n1 73 0\n")]),
            (
                "joints inside a material without row",
                &[
                    ("MPROP 1", "MPROP 2"),
                    ("NPROP 1", "NPROP 2"),
                    ("D1PELA 1 1e9", "D1PELA 2 1e9 1e9"),
                    ("D1PEMU 1 2e9", "D1PEMU 2 2e9 2e9"),
                    ("D1PERO 1 2400", "D1PERO 2 2400 2400"),
                    ("D1PEPE 1 1e10", "D1PEPE 2 1e10 1e10"),
                    ("D1PEFR 1 0.6", "D1PEFR 2 0 0"),
                    ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 2 1 1"),
                    ("I1ELPR 2 0 0", "I1ELPR 2 0 1"),
                    ("MPMCOL 3", "MPMCOL 4"),
                    ("21 3 1\n1 3 0\n", "21 4 1\n2 3 0 1\n"),
                    ("21 3 1\n0 0 0\n", "21 3 1\n0 1 0\n"),
                ],
            ),
            (
                "row with a material that does not exist",
                &[(
                    "MPMROW 1\n/YD/YDPM/I2PMIJ 21 3 1\n",
                    "MPMROW 2\n/YD/YDPM/I2PMIJ 21 3 2\n1 4 0\n",
                )],
            ),
            ("joints of another type", &[("YDPJ/I1PTYP 1 3", "YDPJ/I1PTYP 1 0")]),
            (
                "element type without mechanics",
                &[("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 5"), ("21 3 1\n1 3 0\n", "21 3 1\n1 0 0\n")],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn boundary_conditions_with_surprises() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("axes that are no unit vectors", &[("D1PNXX 2 1 1", "D1PNXX 2 1 2")]),
            ("no code along x", &[("/YD/YDPN/I1PNFX 2 3 1\n", "")]),
            ("code of another program", &[("I1PNFX 2 3 1", "I1PNFX 2 4 1")]),
            ("no amplitudes", &[("/YD/YDPN/D1PNAY 2 0 0\n", "")]),
            ("node set that does not exist", &[("I1NOPR 4 0 1 1 0", "I1NOPR 4 0 2 2 0")]),
            (
                "load-time table that ends early",
                &[("0.0 0.0 0.1 1.0 1.0 1.0", "0.0 0.0 1e-5 1.0 1e-4 1.0")],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn contact_that_does_not_happen() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("sliding states missing", &[("/YD/YDI/MISTATE 6\n", "")]),
            (
                "no boundary nodes",
                &[("I1NOBF 4 1 1 1 1", "I1NOBF 4 0 0 0 0"), ("21 3 1\n1 3 0\n", "21 3 0\n")],
            ),
            ("boundary flag of another program", &[("I1NOBF 4 1 1 1 1", "I1NOBF 4 1 1 3 1")]),
            ("late detection", &[("DIEDI 200", "DIEDI 0")]),
            ("no penalty", &[("/YD/YDPE/D1PEPE 1 1e10\n", "")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn histories_that_stay_what_they_are() {
    let said = one_finding_each(
        Severity::Warning,
        &[
            ("type that is never updated", &[("I1OHYT 1 15", "I1OHYT 1 11")]),
            (
                "stress outside the mesh",
                &[
                    ("I1OHYT 1 15", "I1OHYT 1 1"),
                    ("D1OHYX 1 0.9", "D1OHYX 1 1.9"),
                    ("21 3 1\n1 3 0\n", "21 3 0\n"),
                ],
            ),
            (
                "force away from nodes",
                &[("I1OHYT 1 15", "I1OHYT 1 18"), ("21 3 1\n1 3 0\n", "21 3 0\n")],
            ),
        ],
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
                &[("/YD/YDN/D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0\n", "")],
            ),
            (
                "factors without effect",
                &[("/YD/YDPN/D1PNXX", "/YD/YDPN/D1PNAF 2 1 2\n/YD/YDPN/D1PNXX")],
            ),
            ("no element states", &[("/YD/YDE/MELST 1\n", "")]),
            ("no tensile stretch", &[("/YD/YDPE/D1PSEM 1 0\n", "")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn decks_that_never_run() {
    let mut said = String::new();
    for (doubt, edits) in [
        ("no command to run", ("$YDOIT\n", "")),
        ("comment that is not closed", ("/YD/YDO/MOHYS", "/* histories\n/YD/YDO/MOHYS")),
        ("stop before run", ("$YDOIT\n$YSTOP", "$YSTOP\n$YDOIT")),
    ] {
        let found = verdict(edited(&[edits]).as_bytes());
        assert!(!found.runs, "{doubt}");
        assert!(found.severities.iter().all(|&s| s == Severity::Warning), "{}", found.text);
        let _ = writeln!(said, "== {doubt}\n{}", found.text);
    }
    assert_snapshot!(said);
}

/// In units of tonnes and metres, say, small elements are lighter than what the method takes for
/// massless.
#[test]
fn nodes_that_are_too_light_to_move() {
    let said = one_finding_each(
        Severity::Warning,
        &[(
            "a density in other units than the rest",
            &[("D1PERO 1 2400", "D1PERO 1 2.4e-10"), ("DCSTEC 1e-5", "DCSTEC 1e-12")],
        )],
    );
    assert_snapshot!(said);
}
