//! Mistakes that only a deck in three dimensions can have: one error each, at the right place,
//! with what was expected there and how to mend it. The decks are `bad_decks/base_3d.y` with the
//! replacements listed here; the snapshots are what a user gets to see.

mod support;

use insta::assert_snapshot;
use support::spoilt_deck::{all_say, base_of, verdict};
use yformat::diagnostic::Severity;

#[test]
fn the_base_deck_is_sound() {
    let found = verdict(base_of("3d").as_bytes());
    assert_eq!(found.text, "");
    assert!(found.runs);
}

#[test]
fn shapes_and_types_that_cannot_be() {
    let said = all_say(
        Severity::Error,
        &base_of("3d"),
        &[
            ("inverted tetrahedron", &[("5 6 7 8\n", "5 7 6 8\n")]),
            (
                "flat tetrahedron",
                &[(
                    "D2NCI 21 3 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n0 0 2\n1 0 2\n0 1 2\n0 0 3",
                    "D2NCI 21 3 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n0 0 2\n1 0 2\n0 1 2\n0.5 0.5 2",
                )],
            ),
            ("node used twice", &[("5 6 7 8\n", "5 6 7 6\n")]),
            (
                "three nodes only",
                &[(
                    "I2ELTO 21 4 3\n0 1 2 3\n4 1 3 2\n5 6 7 8",
                    "I2ELTO 21 3 3\n0 1 2\n4 1 3\n5 6 7",
                )],
            ),
            (
                "five nodes",
                &[(
                    "I2ELTO 21 4 3\n0 1 2 3\n4 1 3 2\n5 6 7 8",
                    "I2ELTO 21 5 3\n0 1 2 3 4\n4 1 3 2 -1\n5 6 7 8 -1",
                )],
            ),
            (
                "two coordinates",
                &[(
                    "D2NCC 21 3 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 1 1\n0 0 2\n1 0 2\n0 1 2\n0 0 3",
                    "D2NCC 21 2 9\n0 0\n1 0\n0 1\n0 0\n1 1\n0 0\n1 0\n0 1\n0 0",
                )],
            ),
            ("triangles", &[("I1PTYP 2 21 21", "I1PTYP 2 21 1")]),
            ("ten-node tetrahedra", &[("I1PTYP 2 21 21", "I1PTYP 2 21 11")]),
            ("shells", &[("I1PTYP 2 21 21", "I1PTYP 2 21 31")]),
            ("unknown type", &[("I1PTYP 2 21 21", "I1PTYP 2 21 22")]),
            ("no density", &[("D1PERO 2 2400 2400", "D1PERO 2 2400 0")]),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn joints_and_loads_that_cannot_be() {
    let said = all_say(
        Severity::Error,
        &base_of("3d"),
        &[
            ("no row inside a material", &[("0 1 0\n1 1 0\n", "0 1 0\n0 1 0\n")]),
            ("no row between materials", &[("0 1 0\n1 1 0\n", "1 1 0\n1 1 0\n")]),
            ("no room for nodes", &[("MNOPO 40", "MNOPO 20")]),
            ("no room for joints", &[("MELEM 20", "MELEM 10")]),
            ("no tensile strength", &[("D1PJFT 1 1e6", "D1PJFT 1 0")]),
            ("no shear strength", &[("D1PJFS 1 2e6", "D1PJFS 1 0")]),
            ("table that ends with the run", &[("0 1 1 1\n0 1 1 1", "0 1 1 1\n0 1 1.9e-4 1")]),
            ("table that begins late", &[("0 1 1 1\n0 1 1 1", "0 1 1 1\n0.5 1 1 1")]),
            (
                "axes in one plane",
                &[(
                    "/YD/YDPN/I1PNFX",
                    "/YD/YDPN/D1PNZX 2 1 0\n/YD/YDPN/D1PNZZ 2 0 1\n/YD/YDPN/I1PNFX",
                )],
            ),
        ],
    );
    assert_snapshot!(said);
}

#[test]
fn doubtful_values_are_warned_of() {
    let said = all_say(
        Severity::Warning,
        &base_of("3d"),
        &[
            (
                "axes without table",
                &[(
                    "/YD/YDPN/MPNFACT 2\n/YD/YDPN/NPNFACT 2\n/YD/YDPN/D3PNFAC 231 2 2 2\n0 1 1 1\n0 1 1 1",
                    "/YD/YDPN/D1PNXX 2 0 1\n/YD/YDPN/D1PNXY 2 1 0\n/YD/YDPN/D1PNYX 2 -1 0\n/YD/YDPN/D1PNYY 2 0 1",
                )],
            ),
            ("skew axes", &[("/YD/YDPN/I1PNFX", "/YD/YDPN/D1PNXX 2 1 2\n/YD/YDPN/I1PNFX")]),
            ("joint type of 2D", &[("I1PTYP 1 23", "I1PTYP 1 3")]),
            ("refinement", &[("1 2 3 0 1", "1 2 31 0 1")]),
            ("stress history", &[("I1OHYT 1 15", "I1OHYT 1 1")]),
            (
                "pressure",
                &[("/YD/YDPN/D1PNAZ 2 0 0", "/YD/YDPN/D1PNAZ 2 0 0\n/YD/YDPN/D1PNAP 2 0 1e5")],
            ),
            ("friction", &[("/YD/YDPE/I1PTYP", "/YD/YDPE/D1PEFR 2 0 0.6\n/YD/YDPE/I1PTYP")]),
            ("long time step", &[("DCSTEC 1e-5", "DCSTEC 1e-3")]),
            ("node of no set", &[("I1NOPR 9 0 0 0 1 1 1 1 1 1", "I1NOPR 9 0 0 0 1 1 1 1 1 7")]),
            (
                "no boundary node",
                &[
                    ("I1NOBF 9 1 1 1 1 1 1 1 1 1", "I1NOBF 9 0 0 0 0 0 0 0 0 0"),
                    ("1 2 3 0 1", "1 2 0 0 1"),
                ],
            ),
        ],
    );
    assert_snapshot!(said);
}
