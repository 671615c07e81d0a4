use super::Reader;
use yformat::{database::Field, deck::Stage, diagnostic::Diagnostic};

/// Numbers that switch on what is not simulated.
const NUMBERS: &[(&str, &str)] =
    &[("YSP/NSPD", "rigid bodies"), ("YDC/ICHPRM", "chip removal (Solidity)")];

/// Values that do, where they are not 0.
const VALUES: &[(&str, &str)] = &[
    ("YDC/DCGRST", "the five stages of a load (Solidity)"),
    ("YDC/DCRMCT", "the five stages of a load (Solidity)"),
    ("YDC/DCRMUT", "the five stages of a load (Solidity)"),
    ("YDC/DCRMJT", "jets (Solidity)"),
    ("YDC/DCIMVELX", "impact velocities (Solidity)"),
    ("YDC/DCIMVELY", "impact velocities (Solidity)"),
    ("YDC/DCIMVELZ", "impact velocities (Solidity)"),
    ("YDJ/DEFECT", "weakened joints (Solidity)"),
];

/// Arrays of reals that do, where an entry is not 0.
const REALS: &[(&str, &str)] = &[
    ("YDP/D1CTEX", "thermal expansion (VGW)"),
    ("YDP/D1PEMR", "mass scaling (Solidity)"),
    ("YDB/D1BNAP", "nodal pressures (VGW)"),
    ("YDX/D1NBP", "back pressures (Solidity)"),
    ("YDN/D2NVT", "velocities of a fluid (VGW)"),
];

/// Arrays of integers that do, where an entry is above 0.
const INTEGERS: &[(&str, &str)] = &[
    ("YDB/I1BNTP", "temperatures (VGW)"),
    ("YDB/I1BNHF", "heat fluxes (VGW)"),
    ("YDB/I1BCVT", "convection (VGW)"),
    ("YDX/I1JTP", "jets (Solidity)"),
];

/// Reports what a deck asks for and this program does not simulate.
pub(super) fn check(reader: &mut Reader<'_>) {
    let numbers = NUMBERS.iter().filter(|(name, _)| reader.integer(name) > 0);
    let values = VALUES.iter().filter(|(name, _)| reader.real(name) != 0.0);
    let mut asked: Vec<&(&str, &str)> = numbers.chain(values).collect();
    asked.extend(REALS.iter().filter(|(name, _)| {
        reader.real_field(name).is_some_and(|field| holds(field, |value| value != 0.0))
    }));
    asked.extend(INTEGERS.iter().filter(|(name, _)| {
        reader.integer_field(name).is_some_and(|field| holds(field, |value| value > 0))
    }));
    for (name, what) in asked {
        reader.report(
            Diagnostic::error(
                "scene::not-simulated",
                format!("{name} asks for what is not simulated: {what}"),
            )
            .at(reader.place(name))
            .expected("4-node and 10-node tetrahedra, contact, joints, given forces and velocities")
            .help(format!("set /YD/{name} to 0 to run the deck without")),
        );
    }
    check_stages(reader);
}

/// Whether a given entry is `wanted`.
fn holds<T: Copy>(field: &Field<T>, wanted: impl Fn(T) -> bool) -> bool {
    let given = |index: usize| field.given_shape().get(index).copied().unwrap_or(0);
    match field.rank() {
        1 => (0..given(0)).any(|i| wanted(field.get1(i))),
        2 => (0..given(0)).any(|i| (0..given(1)).any(|j| wanted(field.get2(i, j)))),
        _ => false,
    }
}

fn check_stages(reader: &mut Reader<'_>) {
    let stages: Vec<Stage> = reader.deck.stages().into_iter().filter(|s| s.runs).collect();
    if let Some(second) = stages.get(1) {
        let end = second.items.end.checked_sub(1);
        reader.report(
            Diagnostic::error(
                "scene::not-simulated",
                "a second stage of a .Y3D deck is not simulated",
            )
            .at(end.and_then(|item| reader.deck.word_span(item)))
            .expected("one $YDOIT")
            .help("make a deck of its own for each stage"),
        );
    }
}
