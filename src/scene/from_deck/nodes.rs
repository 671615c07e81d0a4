use super::{Reader, reader::Offenders};
use crate::scene::Nodes;
use nalgebra::SVector;
use yformat::{database::Field, diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read<const D: usize>(reader: &mut Reader<'_>) -> Option<Nodes<D>> {
    check_dimension(reader, D)?;
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
        if !check_components(reader, name, field, D) {
            return None;
        }
    }
    let vectors = |field: Option<&Field<f64>>| -> Vec<SVector<f64, D>> {
        (0..len).map(|n| field.map_or_else(SVector::zeros, |f| vector(f, n))).collect()
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

/// The vector of a node in an array of components by nodes.
pub(super) fn vector<const D: usize>(field: &Field<f64>, node: usize) -> SVector<f64, D> {
    SVector::from_fn(|k, _| field.get2(k, node))
}

fn check_dimension(reader: &mut Reader<'_>, wanted: usize) -> Option<()> {
    let dimension = reader.integer("YDN/NNODIM");
    let place = reader.place("YDN/NNODIM").or_else(|| reader.place("YDN/MNODIM"));
    match dimension {
        _ if dimension == wanted as i64 => Some(()),
        3 => {
            let message = format!(
                "scenes of the {} dialect are simulated in 2D only",
                reader.database.dialect()
            );
            reader.report(
                Diagnostic::error("scene::three-dimensional", message)
                    .at(place)
                    .label("3D")
                    .expected("NNODIM 2")
                    .help("3D scenes are those of the split dialect"),
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

fn check_components(
    reader: &mut Reader<'_>,
    name: &str,
    field: &Field<f64>,
    dimension: usize,
) -> bool {
    let components = field.given_shape().first().copied().unwrap_or(0);
    if components < dimension {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("{name} gives {components} of the {dimension} coordinates of each node"),
            )
            .at(reader.length(name, 0))
            .expected(format!(
                "{dimension} coordinates for each node, after the header `21 {dimension} <number of nodes>`"
            )),
        );
    }
    components >= dimension
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
