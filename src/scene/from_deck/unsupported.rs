use super::Reader;
use yformat::{
    database::{Database, Field},
    diagnostic::Diagnostic,
    keywords::{Keyword, NumberKind, Role},
};

/// Modules of the originals that are not simulated, and the number that switches
/// each of them on.
const MODULES: &[(&str, &str)] = &[
    ("YDB/NBORH", "boreholes"),
    ("YDS/NSOUR", "pressure sources"),
    ("YDSB/NSBAR", "reinforcement bars"),
    ("YDHF/IUSEHF", "hydrofracture"),
];

/// Reports what a deck asks for and this program does not simulate.
pub(super) fn check(reader: &mut Reader<'_>) {
    for (count, what) in MODULES {
        let n = reader.integer(count);
        if n > 0 {
            reader.report(
                Diagnostic::error(
                    "scene::not-simulated",
                    format!("{count} asks for what is not simulated: {what}"),
                )
                .at(reader.place(count))
                .help(format!("set /YD/{count} to 0 to run the deck without {what}")),
            );
        }
    }
    let head = reader.integer("YDI/IIECFF");
    if head != -2 {
        reader.report(
            Diagnostic::error(
                "scene::couple-restart",
                format!("IIECFF is {head}: couple lists of an earlier run are not taken over"),
            )
            .at(reader.place("YDI/IIECFF"))
            .expected("-2, which starts with an empty list")
            .help("set /YD/YDI/IIECFF to -2: contact is detected anew at the first step"),
        );
    }
    note_unused(reader);
}

/// One note about all property arrays that hold something and that neither the
/// original nor this program uses.
fn note_unused(reader: &mut Reader<'_>) {
    let given = reader.deck.assignments().map(|(item, assignment)| (item, assignment.keyword));
    let unused: Vec<(usize, &str)> = given
        .filter(|(_, keyword)| {
            keyword.role == Role::NoEffect
                && keyword.rank() > 0
                && keyword.database.starts_with("YDP")
                && holds_something(reader.database, keyword)
        })
        .map(|(item, keyword)| (item, keyword.name))
        .collect();
    let Some(&(first, _)) = unused.first() else { return };
    let mut names: Vec<&str> = unused.iter().map(|(_, name)| *name).collect();
    names.sort_unstable();
    names.dedup();
    reader.report(
        Diagnostic::note(
            "scene::unused-keyword",
            format!("the original reads {} and never uses it", names.join(", ")),
        )
        .at(reader.deck.word_span(first))
        .help("nothing uses it here, either"),
    );
}

fn holds_something(database: &Database, keyword: &Keyword) -> bool {
    let name = format!("{}/{}", keyword.database, keyword.name);
    match keyword.number {
        NumberKind::Real => database.reals(&name).is_some_and(|f| any(f, |v| v != 0.0)),
        NumberKind::Integer => {
            database.integers(&name).is_some_and(|f| any(f, |v| v != 0 && v != -1))
        }
    }
}

/// Whether a given entry of a one-dimensional array is `wanted`.
fn any<T: Copy>(field: &Field<T>, wanted: impl Fn(T) -> bool) -> bool {
    let given = field.given_shape().last().copied().unwrap_or(0);
    field.rank() == 1 && (0..given).any(|i| wanted(field.get1(i)))
}
