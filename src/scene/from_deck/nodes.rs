use super::{Reader, reader::Offenders};
use crate::scene::Nodes;
use nalgebra::Vector2;
use yformat::{database::Field, diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read(reader: &mut Reader<'_>) -> Option<Nodes<2>> {
    check_dimension(reader)?;
    let len = reader.count("YDN/NNOPO", "YDN/MNOPO", "nodes", 1);
    let initial = reader.required_reals("YDN/D2NCI", "nodes", len);
    let sets = reader.required_integers("YDN/I1NOPR", "nodes", len);
    let current = reader.real_field("YDN/D2NCC").filter(|f| f.item().is_some());
    let current = if current.is_some() {
        reader.required_reals("YDN/D2NCC", "nodes", len)
    } else {
        reader.report(
            Diagnostic::note(
                "scene::current-coordinates",
                "D2NCC is not given: nodes start at their initial coordinates (D2NCI)",
            )
            .at(reader.word("YDN/D2NCI")),
        );
        initial
    };
    let (initial, current, sets) = (initial?, current?, sets?);
    if len == 0 {
        return None;
    }
    for (name, field) in [("YDN/D2NCI", initial), ("YDN/D2NCC", current)] {
        check_components(reader, name, field);
    }
    let vectors = |field: Option<&Field<f64>>| -> Vec<Vector2<f64>> {
        let at = |n| field.map_or(Vector2::zeros(), |f| Vector2::new(f.get2(0, n), f.get2(1, n)));
        (0..len).map(at).collect()
    };
    let flag = reader.integers("YDN/I1NOBF", 0);
    let boundary_flag: Vec<i32> = (0..len).map(|n| to_i32(flag(n))).collect();
    if reader.database.dialect() == Dialect::Split {
        warn_of_flags(reader, &boundary_flag);
    }
    Some(Nodes {
        initial: vectors(Some(initial)),
        current: vectors(Some(current)),
        velocity: vectors(reader.real_field("YDN/D2NVC")),
        boundary_flag,
        set: (0..len).map(|n| to_i32(sets.get1(n))).collect(),
    })
}

fn check_dimension(reader: &mut Reader<'_>) -> Option<()> {
    let dimension = reader.integer("YDN/NNODIM");
    let place = reader.place("YDN/NNODIM").or_else(|| reader.place("YDN/MNODIM"));
    match dimension {
        2 => Some(()),
        3 => {
            reader.report(
                Diagnostic::error("scene::three-dimensional", "scenes in 3D are not simulated yet")
                    .at(place)
                    .label("3D")
                    .expected("NNODIM 2"),
            );
            None
        }
        other => {
            reader.report(
                Diagnostic::error(
                    "scene::dimension",
                    format!("a scene cannot have {other} dimensions"),
                )
                .at(place)
                .expected("NNODIM 2 (or 3)")
                .help("give /YD/YDN/MNODIM 2 and /YD/YDN/NNODIM 2 before the nodes"),
            );
            None
        }
    }
}

fn check_components(reader: &mut Reader<'_>, name: &str, field: &Field<f64>) {
    let components = field.given_shape().first().copied().unwrap_or(0);
    if components < 2 {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("{name} gives {components} of the 2 coordinates of each node"),
            )
            .at(reader.length(name, 0))
            .expected("2 coordinates for each node, after the header `21 2 <number of nodes>`"),
        );
    }
}

fn warn_of_flags(reader: &mut Reader<'_>, flags: &[i32]) {
    let odd = |n: usize| !(-1..=1).contains(&flags[n]);
    if let Some(found) = Offenders::find(flags.len(), odd) {
        reader.report(
            Diagnostic::warning(
                "scene::boundary-flag",
                format!(
                    "boundary flag {} of node {} does not count{}",
                    flags[found.first],
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry("YDN/I1NOBF", found.first))
            .expected("1 for boundary nodes, 0 for others: in this dialect only 1 marks a node"),
        );
    }
}

/// Saturates: codes beyond 32 bits mean nothing anyway.
pub(super) fn to_i32(value: i64) -> i32 {
    i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX })
}
