use super::Reader;
use yformat::{
    database::Field,
    deck::Stage,
    diagnostic::Diagnostic,
    dialect::Dialect,
    keywords::{Keyword, NumberKind, Role, tables},
};

/// Reports what a deck asks for and this program does not simulate.
pub(super) fn check(reader: &mut Reader<'_>) {
    for keyword in tables(Dialect::Y3d).iter().flat_map(|table| table.keywords) {
        let Role::Refused(what) = keyword.role else { continue };
        let name = format!("{}/{}", keyword.database, keyword.name);
        if is_asked_for(reader, keyword, &name) {
            reader.report(
                Diagnostic::error(
                    "scene::not-simulated",
                    format!("{name} asks for what is not simulated: {what}"),
                )
                .at(reader.place(&name))
                .expected(
                    "4-node and 10-node tetrahedra, contact, joints, given forces and velocities",
                )
                .help(format!("set /YD/{name} to 0 to run the deck without")),
            );
        }
    }
    check_stages(reader);
}

/// Whether an integer is above 0, a real other than 0, or an entry of an array is.
fn is_asked_for(reader: &Reader<'_>, keyword: &Keyword, name: &str) -> bool {
    match (keyword.number, keyword.rank()) {
        (NumberKind::Integer, 0) => reader.integer(name) > 0,
        (NumberKind::Real, 0) => reader.real(name) != 0.0,
        (NumberKind::Integer, _) => {
            reader.integer_field(name).is_some_and(|field| holds(field, |value| value > 0))
        }
        (NumberKind::Real, _) => {
            reader.real_field(name).is_some_and(|field| holds(field, |value| value != 0.0))
        }
    }
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
