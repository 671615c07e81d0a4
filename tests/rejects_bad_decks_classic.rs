//! The same as `rejects_bad_decks.rs` for the classic dialect: every mistake gives one error that
//! names the keywords of this dialect.
//!
//! The decks are `bad_decks/base_classic_glued.y` with the replacements listed here.

mod support;

use insta::assert_snapshot;
use std::fmt::Write;
use support::spoilt_deck::{Edits, base_of, edit, verdict};
use yformat::diagnostic::Severity;

/// Words of the split dialect, which mean nothing to users of this one.
const FOREIGN: [&str; 5] = ["YDPE/", "YDPN/", "YDPJ/", "YDPM/", "D1PJF"];

/// What is said about each deck. All must have exactly one finding: an error with a place.
fn one_error_each(cases: &[(&str, Edits<'_>)]) -> String {
    let (mut said, mut wrong) = (String::new(), String::new());
    for (mistake, edits) in cases {
        let found = verdict(edit(base_of("classic_glued"), edits).as_bytes());
        let as_wanted = found.severities == [Severity::Error] && found.placed == [true];
        let is_native = !FOREIGN.iter().any(|word| found.text.contains(word));
        let list = if as_wanted && is_native && !found.runs { &mut said } else { &mut wrong };
        let _ = writeln!(list, "== {mistake}\n{}", found.text);
    }
    assert_eq!(wrong, "", "not one error with a place:\n{wrong}");
    said
}

#[test]
fn the_base_deck_is_sound() {
    let found = verdict(base_of("classic_glued").as_bytes());
    assert_eq!(found.text, "");
    assert!(found.runs);
}

#[test]
fn words_that_are_no_keywords() {
    let said = one_error_each(&[
        ("misspelt keyword", &[("YDC/DCGRAY", "YDC/DCGARY")]),
        (
            "keyword of the book's program",
            &[("/YD/YDP/D1PEKS", "/YD/YDP/D1PEFS 4 0 1e6 0 0\n/YD/YDP/D1PEKS")],
        ),
        ("keyword of the split program", &[("/YD/YDI/NICOUP 0", "/YD/YDI/MISTATE 6")]),
        ("database that does not exist", &[("/YD/YDC/MCSTEP", "/YD/YDX/MCSTEP")]),
        ("included file", &[("/YD/YDO/MOHYS", "$YINCL histories.y\n/YD/YDO/MOHYS")]),
        ("count with point", &[("D1PERO 4", "D1PERO 4.0")]),
        ("integer with exponent", &[("MCSTEP 20", "MCSTEP 2e4")]),
        ("Fortran exponent", &[("D1PELA 4 2.8e9", "D1PELA 4 2.8d9")]),
        ("too many values", &[("I1PTYP 4 1 3 -1 -1", "I1PTYP 4 1 3 -1 -1 -1")]),
        ("array longer than its capacity", &[("D1PJRC 4 0 15 0 0", "D1PJRC 5 0 15 0 0 0")]),
        ("comment among values", &[("D1PERO 4 2500", "D1PERO 4 2500 /* kg/m3 */")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn counts_that_are_wrong() {
    let said = one_error_each(&[
        ("no property sets", &[("/YD/YDP/NPROP 4\n", "")]),
        ("more property sets than room", &[("NPROP 4", "NPROP 5")]),
        (
            "more property sets than any memory holds",
            &[("MPROP 4", "MPROP 9000000000000"), ("NPROP 4", "NPROP 9000000000000")],
        ),
        ("more elements than room", &[("NELEM 2", "NELEM 8")]),
        ("more nodes than given", &[("NNOPO 4", "NNOPO 5")]),
        ("fewer types than sets", &[("I1PTYP 4 1 3 -1 -1", "I1PTYP 3 1 3 -1")]),
        ("no room for the elements of joints", &[("MELEM 7", "MELEM 6")]),
        ("no room for the nodes of joints", &[("MNOPO 10", "MNOPO 9")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn arrays_that_are_missing() {
    let said = one_error_each(&[
        ("types of sets", &[("/YD/YDP/I1PTYP 4 1 3 -1 -1\n", "")]),
        ("Lamé constant", &[("/YD/YDP/D1PELA 4 2.8e9 0 0 0\n", "")]),
        ("density", &[("/YD/YDP/D1PERO 4 2500 0 0 0\n", "")]),
        ("tensile strength", &[("/YD/YDP/D1PEFT 4 0 1e6 0 0\n", "")]),
        ("fracture energy", &[("/YD/YDP/D1PEGT 4 0 2 0 0\n", "")]),
        ("cohesion", &[("/YD/YDP/D1PCOH 4 0 2e6 0 0\n", "")]),
        ("cohesion of joints", &[("D1PCOH 4 0 2e6 0 0", "D1PCOH 1 2e6")]),
        ("codes of nodes", &[("/YD/YDP/I1PNFX 4 0 0 3 1\n", "")]),
        ("amplitudes", &[("/YD/YDP/D1PNAX 4 0 0 0 5e3\n", "")]),
        ("property sets of nodes", &[("/YD/YDN/I1NOPR 4 2 3 2 3\n", "")]),
        ("element nodes", &[("/YD/YDE/I2ELTO 21 3 2\n0 1 3\n0 3 2\n", "")]),
        ("history types", &[("/YD/YDO/I1OHYT 1 15\n", "")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn values_without_sense() {
    let said = one_error_each(&[
        ("negative time step", &[("DCSTEC 1e-6", "DCSTEC -1e-6")]),
        ("no output", &[("/YD/YDC/ICOUTF 10\n", "")]),
        ("output every 0 steps", &[("ICOUTF 10", "ICOUTF 0")]),
        ("output every -1 steps", &[("ICOUTF 10", "ICOUTF -1")]),
        ("numbers without digits", &[("ICOUTP 4", "ICOUTP 0")]),
        ("numbers with too many digits", &[("ICOUTP 4", "ICOUTP 10")]),
        ("model of friction that does not exist", &[("ICFMTY 0", "ICFMTY 2")]),
        ("kind of aperture that does not exist", &[("ICIATY 0", "ICIATY 2")]),
        ("couples of an earlier run", &[("IIECFF -2", "IIECFF 17")]),
        ("three dimensions", &[("NNODIM 2", "NNODIM 3")]),
        ("zero density", &[("D1PERO 4 2500", "D1PERO 4 0")]),
        ("negative contact penalty", &[("D1PEPC 4 1e11", "D1PEPC 4 -1e11")]),
        ("negative friction between sets", &[("D1PBIF 4 0.5", "D1PBIF 4 -0.5")]),
        ("softening triangles", &[("I1PTYP 4 1 3", "I1PTYP 4 4 3")]),
        ("axes without length", &[("D1PNXX 4 0 0 1 1", "D1PNXX 4 0 0 1 0")]),
        ("property set that does not exist", &[("I1ELPR 2 0 0", "I1ELPR 2 0 4")]),
        ("node that does not exist", &[("0 3 2\n", "0 3 4\n")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn joints_that_cannot_be_made() {
    let said = one_error_each(&[
        ("zero tensile strength", &[("D1PEFT 4 0 1e6", "D1PEFT 4 0 0")]),
        ("zero joint penalty", &[("D1PEPE 4 0 1e11", "D1PEPE 4 0 0")]),
        ("negative cohesion", &[("D1PCOH 4 0 2e6", "D1PCOH 4 0 -2e6")]),
        ("negative energy of opening", &[("D1PEGT 4 0 2", "D1PEGT 4 0 -2")]),
        ("negative energy of sliding", &[("D1PEGS 4 0 8", "D1PEGS 4 0 -8")]),
        ("no joint set", &[("/YD/YDP/I1PEJP 4 1 0 0 0\n", "")]),
        ("joint set that does not exist", &[("I1PEJP 4 1", "I1PEJP 4 7")]),
        ("joints of a set of nodes", &[("I1PEJP 4 1", "I1PEJP 4 2")]),
        ("joints of a set without type", &[("I1PTYP 4 1 3", "I1PTYP 4 1 0")]),
        ("no cohesion", &[("D1PCOH 4 0 2e6", "D1PCOH 4 0 0")]),
        ("refinement beyond all bounds", &[("I1PEMN 4 3", "I1PEMN 4 3222222222222")]),
        ("joints in a run that goes on", &[("NCSTEP 0", "NCSTEP 5")]),
        (
            "run that goes on without the state of its joints",
            &[
                ("NCSTEP 0", "NCSTEP 5"),
                ("NELEM 2", "NELEM 3"),
                ("I1ELTY 2 -1 -1", "I1ELTY 3 -1 -1 0"),
                ("I1ELPR 2 0 0", "I1ELPR 3 0 0 1"),
                ("21 3 2\n0 1 3\n0 3 2\n", "21 4 3\n0 1 3 -1\n0 3 2 -1\n0 1 1 0\n"),
                ("I1PEMN 4 3", "I1PEMN 4 0"),
            ],
        ),
        (
            "joint of no kind",
            &[
                ("NELEM 2", "NELEM 3"),
                ("I1ELPR 2 0 0", "I1ELPR 3 0 0 1"),
                ("21 3 2\n0 1 3\n0 3 2\n", "21 4 3\n0 1 3 -1\n0 3 2 -1\n0 1 1 0\n"),
                ("I1PEMN 4 3", "I1PEMN 4 0"),
            ],
        ),
        (
            "joint with a property set that does not exist",
            &[
                ("NELEM 2", "NELEM 3"),
                ("I1ELTY 2 -1 -1", "I1ELTY 3 -1 -1 0"),
                ("I1ELPR 2 0 0", "I1ELPR 3 0 0 4"),
                ("21 3 2\n0 1 3\n0 3 2\n", "21 4 3\n0 1 3 -1\n0 3 2 -1\n0 1 1 0\n"),
                ("I1PEMN 4 3", "I1PEMN 4 0"),
            ],
        ),
        ("triangle of a kind of joints", &[("I1ELTY 2 -1 -1", "I1ELTY 2 -1 0")]),
    ]);
    assert_snapshot!(said);
}
