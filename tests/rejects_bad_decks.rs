//! Every kind of mistake that a deck can have gives one error, at the right place, with what was
//! expected there and how to mend it.
//!
//! The decks are `bad_decks/base.y` with the replacements listed here. The snapshots are meant to
//! be read: they are what a user gets to see.

mod support;

use insta::assert_snapshot;
use std::fmt::Write;
use support::spoilt_deck::{self, Edits, edited, verdict};
use yformat::diagnostic::Severity;

/// What is said about each deck. All must have exactly one finding: an error with a place.
fn one_error_each(cases: &[(&str, Edits<'_>)]) -> String {
    let (mut said, mut wrong) = (String::new(), String::new());
    for (mistake, edits) in cases {
        let found = verdict(edited(edits).as_bytes());
        let as_wanted = found.severities == [Severity::Error] && found.placed == [true];
        let list = if as_wanted && !found.runs { &mut said } else { &mut wrong };
        let _ = writeln!(list, "== {mistake}\n{}", found.text);
    }
    assert_eq!(wrong, "", "not one error with a place:\n{wrong}");
    said
}

#[test]
fn the_base_deck_is_sound() {
    let found = verdict(spoilt_deck::base().as_bytes());
    assert_eq!(found.text, "");
    assert!(found.runs);
}

#[test]
fn words_that_are_no_keywords() {
    let said = one_error_each(&[
        ("misspelt keyword", &[("YDC/DCGRAY", "YDC/DCGARY")]),
        ("lower-case keyword", &[("/YD/YDC/MCSTEP", "/yd/ydc/mcstep")]),
        ("keyword of another dialect", &[("/YD/YDC/ICOUTF", "/YD/YDC/ICSAVF")]),
        ("keyword of no dialect", &[("/YD/YDC/ICOUTF", "/YD/YDC/SAVEALL")]),
        ("database of another dialect", &[("/YD/YDPE/D1PEPE 1 1e10", "/YD/YDP/D1PEPE 1 1e10")]),
        ("database that does not exist", &[("/YD/YDC/MCSTEP", "/YD/YDX/MCSTEP")]),
        ("word without meaning", &[("/YD/YDC/DCSTEC 1e-5", "/YD/YDC/DCSTEC 1e-5 seconds")]),
        ("misspelt command", &[("$YDOIT", "$YDOTI")]),
        ("comment sign of another language", &[("/YD/YDC/ICOUTF", "# output\n/YD/YDC/ICOUTF")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn numbers_that_cannot_be_read() {
    let said = one_error_each(&[
        ("integer with exponent", &[("MCSTEP 20", "MCSTEP 2e4")]),
        ("integer with point", &[("NNOPO 4\n/YD/YDN/D2NCI", "NNOPO 4.0\n/YD/YDN/D2NCI")]),
        ("count with point", &[("I1ELPR 2 0 0", "I1ELPR 2.0 0 0")]),
        ("length with point", &[("D2NCC 21 2 4\n", "D2NCC 21 2.0 4\n")]),
        ("count of reals with point", &[("D1PERO 1 2400", "D1PERO 1.0 2400")]),
        ("node number with point", &[("0 2 3\n", "0 2.0 3\n")]),
        ("Fortran exponent", &[("D1PELA 1 1e9", "D1PELA 1 1.0d9")]),
        ("decimal comma", &[("DCGRAY -9.81", "DCGRAY -9,81")]),
        ("sign apart from its number", &[("DCGRAY -9.81", "DCGRAY - 9.81")]),
        ("fraction among integers", &[("I1ELPR 2 0 0", "I1ELPR 2 0 .5")]),
        ("word among values", &[("I1ELPR 2 0 0", "I1ELPR 2 0 brick")]),
        (
            "not a number",
            &[(
                "1.0 0.0\n1.0 1.0\n0.0 1.0\n/YD/YDN/D2NCC",
                "nan 0.0\n1.0 1.0\n0.0 1.0\n/YD/YDN/D2NCC",
            )],
        ),
        ("infinity", &[("D1PELA 1 1e9", "D1PELA 1 inf")]),
        ("number beyond range", &[("D1PELA 1 1e9", "D1PELA 1 1e999")]),
        ("integer beyond range", &[("MCSTEP 20", "MCSTEP 99999999999999999999")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn arrays_with_a_wrong_count() {
    let said = one_error_each(&[
        ("too many values", &[("I1ELPR 2 0 0", "I1ELPR 2 0 0 0")]),
        ("too many records", &[("0 2 3\n", "0 2 3\n0 3 1\n")]),
        ("two values for a scalar", &[("DCSTEC 1e-5", "DCSTEC 1e-5 2e-5")]),
        ("too few nodes", &[("D2NCI 21 2 4\n0.0 0.0\n", "D2NCI 21 2 3\n")]),
        (
            "too few materials",
            &[
                ("MPROP 1", "MPROP 2"),
                ("NPROP 1", "NPROP 2"),
                ("YDPE/D1PELA 1 1e9", "YDPE/D1PELA 2 1e9 1e9"),
                ("YDPE/D1PEMU 1 2e9", "YDPE/D1PEMU 2 2e9 2e9"),
                ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 2 1 1"),
            ],
        ),
        (
            "array longer than its capacity",
            &[("I1NOPR 4 0 1 1 0", "I1NOPR 12 0 1 1 0 0 0 0 0 0 0 0 0")],
        ),
        (
            "array before its size",
            &[
                ("/YD/YDPE/MPROP 1\n", ""),
                ("/YD/YDPE/D1PERO 1 2400\n", "/YD/YDPE/D1PERO 1 2400\n/YD/YDPE/MPROP 1\n"),
                ("/YD/YDPE/D1PELA 1 1e9\n/YD/YDPE/D1PEMU 1 2e9\n", ""),
            ],
        ),
        ("size missing", &[("/YD/YDN/MNOPO 10\n", "")]),
        (
            "one component for each node",
            &[(
                "D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0",
                "D2NCC 21 1 4\n0.0 1.0 1.0 0.0",
            )],
        ),
        (
            "more nodes than room",
            &[
                ("MNOPO 10", "MNOPO 3"),
                ("D2NCI 21 2 4\n0.0 0.0", "D2NCI 21 2 3"),
                ("D2NCC 21 2 4\n0.0 0.0", "D2NCC 21 2 3"),
                ("I1NOBF 4 1", "I1NOBF 3"),
                ("I1NOPR 4 0", "I1NOPR 3"),
            ],
        ),
        ("more elements than room", &[("NELEM 2", "NELEM 8")]),
        ("more materials than room", &[("NPROP 1", "NPROP 2")]),
        (
            "more joint sets than room",
            &[("NPJSET 1\n/YD/YDPJ/D1PJFT", "NPJSET 2\n/YD/YDPJ/D1PJFT")],
        ),
        (
            "more node sets than room",
            &[("NPNSET 2\n/YD/YDPN/MPNFACT", "NPNSET 3\n/YD/YDPN/MPNFACT")],
        ),
        ("no nodes", &[("/YD/YDN/NNOPO 4\n", "")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn arrays_that_are_missing() {
    let said = one_error_each(&[
        ("coordinates", &[("/YD/YDN/D2NCI 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0\n", "")]),
        ("node sets of nodes", &[("/YD/YDN/I1NOPR 4 0 1 1 0\n", "")]),
        ("element nodes", &[("/YD/YDE/I2ELTO 21 3 2\n0 1 2\n0 2 3\n", "")]),
        ("element properties", &[("/YD/YDE/I1ELPR 2 0 0\n", "")]),
        ("element types", &[("/YD/YDPE/I1PTYP 1 1\n", "")]),
        ("Lamé constant", &[("/YD/YDPE/D1PELA 1 1e9\n", "")]),
        ("density", &[("/YD/YDPE/D1PERO 1 2400\n", "")]),
        ("history types", &[("/YD/YDO/I1OHYT 1 15\n", "")]),
        ("history factors", &[("/YD/YDO/D1OHYF 1 1\n", "")]),
        ("joint table", &[("/YD/YDPM/I2PMIJ 21 3 1\n0 0 0\n", "")]),
        ("joint strengths", &[("/YD/YDPJ/D1PJFT 1 1e6\n", "")]),
        ("joint types", &[("/YD/YDPJ/I1PTYP 1 3\n", "")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn meshes_that_do_not_fit_together() {
    let said = one_error_each(&[
        ("node that does not exist", &[("0 2 3\n", "0 2 5\n")]),
        ("node numbers from 1", &[("0 1 2\n0 2 3\n", "1 2 3\n1 3 4\n")]),
        ("negative node", &[("0 2 3\n", "0 -1 3\n")]),
        (
            "fourth node that does not exist",
            &[("I2ELTO 21 3 2\n0 1 2\n0 2 3\n", "I2ELTO 21 4 2\n0 1 2 -1\n0 2 3 9\n")],
        ),
        ("node used twice", &[("0 2 3\n", "0 2 2\n")]),
        ("clockwise triangle", &[("0 2 3\n", "0 3 2\n")]),
        ("two clockwise triangles", &[("0 1 2\n0 2 3\n", "0 2 1\n0 3 2\n")]),
        (
            "flat triangle",
            &[(
                "1.0 0.0\n1.0 1.0\n0.0 1.0\n/YD/YDN/D2NCC",
                "1.0 0.0\n1.0 1.0\n2.0 2.0\n/YD/YDN/D2NCC",
            )],
        ),
        (
            "inverted current coordinates",
            &[(
                "1.0 0.0\n1.0 1.0\n0.0 1.0\n/YD/YDN/I1NOBF",
                "1.0 0.0\n1.0 1.0\n1.0 0.0\n/YD/YDN/I1NOBF",
            )],
        ),
        ("material that does not exist", &[("I1ELPR 2 0 0", "I1ELPR 2 0 3")]),
        ("materials numbered from 1", &[("I1ELPR 2 0 0", "I1ELPR 2 1 1")]),
        (
            "two nodes for each element",
            &[("I2ELTO 21 3 2\n0 1 2\n0 2 3\n", "I2ELTO 21 2 2\n0 1\n0 2\n")],
        ),
    ]);
    assert_snapshot!(said);
}

#[test]
fn control_values_without_sense() {
    let said = one_error_each(&[
        ("no time step", &[("/YD/YDC/DCSTEC 1e-5\n", "")]),
        ("zero time step", &[("DCSTEC 1e-5", "DCSTEC 0")]),
        ("negative time step", &[("DCSTEC 1e-5", "DCSTEC -1e-5")]),
        ("negative first step", &[("MCSTEP 20", "MCSTEP 20 /YD/YDC/NCSTEP -5")]),
        ("negative contact buffer", &[("DIEZON 0.1", "DIEZON -0.1")]),
        ("couples of an earlier run", &[("MISTATE 6", "MISTATE 6 /YD/YDI/IIECFF 17")]),
        ("boreholes", &[("$YDOIT", "/YD/YDB/MBORH 1 /YD/YDB/NBORH 1\n$YDOIT")]),
        ("pressure sources", &[("$YDOIT", "/YD/YDS/MSOUR 2 /YD/YDS/NSOUR 2\n$YDOIT")]),
        ("three dimensions", &[("/YD/YDN/NNODIM 2", "/YD/YDN/NNODIM 3")]),
        ("five dimensions", &[("/YD/YDN/NNODIM 2", "/YD/YDN/NNODIM 5")]),
        ("no dimension", &[("/YD/YDN/NNODIM 2\n", "")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn materials_that_cannot_be() {
    let said = one_error_each(&[
        ("negative density", &[("D1PERO 1 2400", "D1PERO 1 -2400")]),
        ("zero density", &[("D1PERO 1 2400", "D1PERO 1 0")]),
        ("negative stiffness", &[("D1PELA 1 1e9", "D1PELA 1 -1e9")]),
        ("negative friction", &[("D1PEFR 1 0.6", "D1PEFR 1 -0.6")]),
        ("friction without tangential penalty", &[("/YD/YDPE/D1PEPT 1 1e9\n", "")]),
        ("tetrahedra in the plane", &[("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 21")]),
        (
            "softening without stretch",
            &[("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 4"), ("21 3 1\n1 3 0\n", "21 3 1\n1 0 0\n")],
        ),
        (
            "softening without damage row",
            &[
                ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 4 /YD/YDPE/I1PSDE 1 2"),
                ("D1PSEM 1 0", "D1PSEM 1 0.1"),
                ("21 3 1\n1 3 0\n", "21 3 1\n1 0 0\n"),
            ],
        ),
    ]);
    assert_snapshot!(said);
}

#[test]
fn joints_that_cannot_be_made() {
    let said = one_error_each(&[
        ("joint set that does not exist", &[("0 0 0\n\n/YD/YDPN", "0 0 1\n\n/YD/YDPN")]),
        ("negative joint set", &[("0 0 0\n\n/YD/YDPN", "0 0 -1\n\n/YD/YDPN")]),
        ("no joint sets", &[("/YD/YDPJ/NPJSET 1\n", "")]),
        ("zero tensile strength", &[("D1PJFT 1 1e6", "D1PJFT 1 0")]),
        ("zero shear strength", &[("D1PJFS 1 2e6", "D1PJFS 1 0")]),
        ("zero joint penalty", &[("D1PJPE 1 1e10", "D1PJPE 1 0")]),
        ("negative fracture energy", &[("D1PJGF 1 100", "D1PJGF 1 -100")]),
        ("no room for the elements of joints", &[("MELEM 7", "MELEM 6")]),
        ("no room for the nodes of joints", &[("MNOPO 10", "MNOPO 9")]),
        ("mesh record with too many materials", &[("21 3 1\n1 3 0\n", "21 3 1\n2 3 0\n")]),
        ("mesh record without materials", &[("21 3 1\n1 3 0\n", "21 3 1\n0 3 0\n")]),
        (
            "mesh record with a material that does not exist",
            &[("21 3 1\n1 3 0\n", "21 3 1\n1 3 1\n")],
        ),
        ("refinement beyond all bounds", &[("21 3 1\n1 3 0\n", "21 3 1\n1 3222222222222 0\n")]),
        ("code and count exchanged", &[("21 3 1\n1 3 0\n", "21 3 1\n3 1 0\n")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn boundary_conditions_that_are_undefined() {
    let said = one_error_each(&[
        (
            "load-time table with too few sets",
            &[("D3PNFAC 231 2 2 3\n0.0 1.0 0.1 1.0 1.0 1.0\n", "D3PNFAC 231 2 1 3\n")],
        ),
        (
            "load-time table with too few points",
            &[("NPNFACT 3\n/YD/YDPN/D3P", "NPNFACT 4\n/YD/YDPN/D3P"), ("MPNFACT 3", "MPNFACT 4")],
        ),
        (
            "load-time table that goes back",
            &[("0.0 0.0 0.1 1.0 1.0 1.0", "0.0 0.0 0.1 1.0 0.05 1.0")],
        ),
        (
            "load-time table with an interval of no length",
            &[("0.0 1.0 0.1 1.0 1.0 1.0", "0.0 1.0 0.0 1.0 1.0 1.0")],
        ),
        (
            "parallel local axes",
            &[("D1PNYX 2 0 0", "D1PNYX 2 0 1"), ("D1PNYY 2 1 1", "D1PNYY 2 1 0")],
        ),
        ("local axis without length", &[("D1PNXX 2 1 1", "D1PNXX 2 1 0")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn comments_that_go_wrong() {
    let many = format!("/* {}*/\n$YDOIT", "word ".repeat(120));
    let said = one_error_each(&[
        ("comment among values", &[("I1NOPR 4 0 1 1 0", "I1NOPR 4 0 1 /* right side */ 1 0")]),
        ("comment before the value", &[("DCSTEC 1e-5", "DCSTEC /* s */ 1e-5")]),
        ("comment before the values", &[("D1PERO 1 2400", "D1PERO 1 /* kg/m3 */ 2400")]),
        ("too many words", &[("$YDOIT", &many)]),
        ("end of a comment that was not opened", &[("$YDOIT", "*/\n$YDOIT")]),
    ]);
    assert_snapshot!(said);
}

#[test]
fn counts_that_no_memory_could_hold() {
    let said = one_error_each(&[
        (
            "nodes without values",
            &[("NNOPO 4\n/YD", "NNOPO 40000000\n/YD"), ("MNOPO 10", "MNOPO 9000000000000")],
        ),
        (
            "number of nodes",
            &[("NNOPO 4\n/YD", "NNOPO 4000000000\n/YD"), ("MNOPO 10", "MNOPO 9000000000000")],
        ),
        ("array of many lengths", &[("D2NCI 21 2 4", "D2NCI 21 9000000000 9000000000")]),
        ("array of missing values", &[("I1NOPR 4 0 1 1 0", "I1NOPR 9000000000 0 1 1 0")]),
        (
            "histories",
            &[
                ("NOHYS 1\n/YD/YDO/DOHYP", "NOHYS 9000000000000\n/YD/YDO/DOHYP"),
                ("MOHYS 1", "MOHYS 9000000000000"),
            ],
        ),
        (
            "node sets",
            &[
                ("NPNSET 2\n/YD/YDPN/MPNFACT", "NPNSET 9000000000000\n/YD/YDPN/MPNFACT"),
                ("MPNSET 2", "MPNSET 9000000000000"),
            ],
        ),
        (
            "joint sets",
            &[
                ("NPJSET 1\n/YD/YDPJ/D1PJFT", "NPJSET 9000000000000\n/YD/YDPJ/D1PJFT"),
                ("MPJSET 1", "MPJSET 9000000000000"),
            ],
        ),
        (
            "load-time points",
            &[
                ("NPNFACT 3\n/YD/YDPN/D3P", "NPNFACT 9000000000000\n/YD/YDPN/D3P"),
                ("MPNFACT 3", "MPNFACT 9000000000000"),
            ],
        ),
    ]);
    assert_snapshot!(said);
}
