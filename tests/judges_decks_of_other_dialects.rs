//! Mistakes and doubtful values in decks of the classic dialect and of Y-Geo give one finding each,
//! at the right place and in the words of that dialect.
//!
//! The decks are `bad_decks/base_classic.y` and `base_ygeo.y` with the replacements listed here.

mod support;

use insta::assert_snapshot;
use support::spoilt_deck::{Edits, all_say, base_of, edit, verdict};
use yformat::diagnostic::Severity;

/// What is said about each deck. All must have exactly one finding of that severity, with a place.
fn one_each(dialect: &str, severity: Severity, cases: &[(&str, Edits<'_>)]) -> String {
    all_say(severity, &base_of(dialect), cases)
}

#[test]
fn the_base_decks_are_sound() {
    for dialect in ["classic", "ygeo"] {
        let found = verdict(base_of(dialect).as_bytes());
        assert_eq!(found.text, "");
        assert!(found.runs);
    }
}

#[test]
fn classic_decks_with_mistakes() {
    let said = one_each(
        "classic",
        Severity::Error,
        &[
            ("keyword of the book alone", &[("YDP/D1PEGT 3", "YDP/D1PEGF 3")]),
            ("keyword of the split dialect", &[("YDI/DIEDI 200", "YDI/MISTATE 6")]),
            ("no property sets", &[("NPROP 3", "NPROP 0")]),
            ("more property sets than room", &[("NPROP 3", "NPROP 4")]),
            ("too few densities", &[("D1PERO 3 2400 0 0", "D1PERO 0")]),
            ("types missing", &[("/YD/YDP/I1PTYP 3 1 3 -1\n", "")]),
            ("density missing", &[("D1PERO 3 2400 0 0", "D1PERO 3 0 0 0")]),
            ("tensile strength missing", &[("D1PEFT 3 0 1e6 0", "D1PEFT 3 0 0 0")]),
            ("joint penalty missing", &[("D1PEPE 3 0 1e11 0", "D1PEPE 3 0 0 0")]),
            ("cohesion missing", &[("D1PCOH 3 2e6 2e6 0", "D1PCOH 3 0 0 0")]),
            ("joints of a set that is none of joints", &[("I1PEJP 3 1 0 0", "I1PEJP 3 2 0 0")]),
            ("joints of a set that does not exist", &[("I1PEJP 3 1 0 0", "I1PEJP 3 7 0 0")]),
            ("no room for joints", &[("MELEM 10", "MELEM 4")]),
            ("no room for nodes", &[("MNOPO 10", "MNOPO 7")]),
            ("element of a property that does not exist", &[("I1ELPR 2 0 0", "I1ELPR 2 0 5")]),
            ("node that does not exist", &[("0 2 3\n", "0 2 9\n")]),
            ("triangle that is called a joint", &[("I1ELTY 2 -1 -1", "I1ELTY 2 -1 0")]),
            ("softening triangles", &[("I1PTYP 3 1 3 -1", "I1PTYP 3 4 3 -1")]),
            ("axes without direction", &[("D1PNXX 3 1 1 1", "D1PNXX 3 0 0 0")]),
            ("no output interval", &[("ICOUTF 10", "ICOUTF 0")]),
            ("too many characters for a number", &[("ICOUTP 4", "ICOUTP 12")]),
            ("friction model that does not exist", &[("ICFMTY 0", "ICFMTY 3")]),
            ("aperture that does not exist", &[("ICIATY 0", "ICIATY 2")]),
            ("no time step", &[("DCSTEC 1e-6", "DCSTEC 0")]),
            ("flat triangle", &[("0 1 2\n0 2 3\n/YD/YDE/I2ELJP", "0 1 2\n0 2 2\n/YD/YDE/I2ELJP")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn classic_decks_with_doubtful_values() {
    let said = one_each(
        "classic",
        Severity::Warning,
        &[
            ("no time of settling", &[("/YD/YDC/DCGRST 0\n", "")]),
            ("no scale of stresses", &[("/YD/YDC/DCSIZS 1e8\n", "")]),
            ("nodes of a set of triangles", &[("I1NOPR 4 2 2 2 2", "I1NOPR 4 2 2 2 0")]),
            ("nodes of no set", &[("I1NOPR 4 2 2 2 2", "I1NOPR 4 2 2 2 9")]),
            ("time step too long", &[("DCSTEC 1e-6", "DCSTEC 1e-2")]),
            (
                "clockwise triangle",
                &[("0 1 2\n0 2 3\n/YD/YDE/I2ELJP", "0 1 2\n0 3 2\n/YD/YDE/I2ELJP")],
            ),
            ("code that freezes", &[("I1PNFX 3 1 1 1", "I1PNFX 3 1 1 5")]),
            ("nothing to do", &[("MCSTEP 20", "MCSTEP 0")]),
            (
                "mesh codes overwritten",
                &[("I1PEMN 3 3 0 0", "I1PEMN 3 3 0 0\n/YD/YDP/I1PNFZ 3 3 0 0")],
            ),
        ],
    );
    assert_snapshot!(said);
}

/// Every set of joints acts on every joint: that is said whatever else is doubtful.
#[test]
fn several_sets_of_joints_are_told() {
    let deck = edit(
        base_of("classic"),
        &[
            ("I1PTYP 3 1 3 -1", "I1PTYP 3 1 3 3"),
            ("D1PEFT 3 0 1e6 0", "D1PEFT 3 0 1e6 1e6"),
            ("D1PCOH 3 2e6 2e6 0", "D1PCOH 3 2e6 2e6 2e6"),
            ("D1PEPE 3 0 1e11 0", "D1PEPE 3 0 1e11 1e11"),
        ],
    );
    let found = verdict(deck.as_bytes());
    assert!(found.runs && found.text.contains("scene::joint-sets"), "{}", found.text);
}

#[test]
fn ygeo_decks_with_mistakes() {
    let said = one_each(
        "ygeo",
        Severity::Error,
        &[
            (
                "keyword of the split dialect",
                &[("YDPE/MPEROW 1", "YDPE/D1PEPT 1 1e9\n/YD/YDPE/MPEROW 1")],
            ),
            ("no contact table", &[("/YD/YDPE/D2PEINT 21 5 1 0 0 0.5 1e10 1e9\n", "")]),
            (
                "contact table with too few columns",
                &[("21 5 1 0 0 0.5 1e10 1e9", "21 4 1 0 0 0.5 1e10")],
            ),
            ("friction without tangential penalty", &[("0 0 0.5 1e10 1e9", "0 0 0.5 1e10 0")]),
            (
                "plane stress without Young's modulus",
                &[("D1PEEM 1 2e9", "D1PEEM 1 0"), ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 5")],
            ),
            (
                "Poisson's ratio of one half",
                &[("D1PENU 1 0.25", "D1PENU 1 0.5"), ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 6")],
            ),
            ("transverse isotropy without constants", &[("I1USAN 1 0", "I1USAN 1 1")]),
            ("hydrofracture", &[("/YD/YDO/MOHYS 1", "/YD/YDHF/IUSEHF 1\n/YD/YDO/MOHYS 1")]),
            (
                "reinforcement bars",
                &[("/YD/YDO/MOHYS 1", "/YD/YDSB/MSBAR 1 /YD/YDSB/NSBAR 1\n/YD/YDO/MOHYS 1")],
            ),
            (
                "boreholes",
                &[("/YD/YDO/MOHYS 1", "/YD/YDB/MBORH 1 /YD/YDB/NBORH 1\n/YD/YDO/MOHYS 1")],
            ),
            (
                "fracture network without nodes",
                &[("/YD/YDO/MOHYS 1", "/YD/YDFN/IUSEFN 1\n/YD/YDO/MOHYS 1")],
            ),
            (
                "fracture network of no kind",
                &[("/YD/YDO/MOHYS 1", "/YD/YDFN/IUSEFN 7\n/YD/YDO/MOHYS 1")],
            ),
            (
                "fracture through a node that does not exist",
                &[(
                    "/YD/YDO/MOHYS 1",
                    "/YD/YDFN/MDFNFR 1 /YD/YDFN/MDFNNO 2 /YD/YDFN/IUSEFN 1 /YD/YDFN/I2DFNN 21 2 1 0 9\n/YD/YDO/MOHYS 1",
                )],
            ),
            ("joint set that does not exist", &[("I2PMIJ 21 3 1 0 0 0", "I2PMIJ 21 3 1 0 0 4")]),
            ("no output interval", &[("ICOUTF 10", "ICOUTF 0")]),
            ("no room for joints", &[("MELEM 10", "MELEM 4")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn ygeo_decks_with_doubtful_values() {
    let said = one_each(
        "ygeo",
        Severity::Warning,
        &[
            (
                "pair without row",
                &[
                    ("21 5 1 0 0 0.5 1e10 1e9", "21 5 1 1 1 0.5 1e10 1e9"),
                    ("YDPE/MPROP 1", "YDPE/MPROP 1"),
                ],
            ),
            ("no sliding states", &[("/YD/YDI/MISTATE 6\n", "")]),
            ("code beyond all", &[("I1PNFY 1 1", "I1PNFY 1 5")]),
            (
                "history in no triangle",
                &[("I1OHYT 1 15", "I1OHYT 1 1"), ("I2PMSET 21 3 1 1 3 0", "I2PMSET 21 3 1 1 0 0")],
            ),
        ],
    );
    assert_snapshot!(said);
    let notes = one_each(
        "ygeo",
        Severity::Note,
        &[(
            "arrays that nothing uses",
            &[("/YD/YDPE/D1PSEM 1 0", "/YD/YDPE/D1PSEM 1 0\n/YD/YDPE/D1PEPE 1 1e10")],
        )],
    );
    assert_snapshot!(notes);
}
