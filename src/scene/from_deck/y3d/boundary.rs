use super::Reader;
use crate::scene::{Condition, NodeSet, Nodes, from_deck::reader::Offenders};
use nalgebra::SMatrix;
use yformat::diagnostic::Diagnostic;

const CODES: [&str; 3] = ["YDB/I1BNVX", "YDB/I1BNVY", "YDB/I1BNVZ"];
const VELOCITIES: [&str; 3] = ["YDB/D1BNVX", "YDB/D1BNVY", "YDB/D1BNVZ"];
const FORCES: [&str; 3] = ["YDB/D1BNFX", "YDB/D1BNFY", "YDB/D1BNFZ"];
const ACCELERATIONS: [&str; 3] = ["YDB/D1BNAX", "YDB/D1BNAY", "YDB/D1BNAZ"];

/// Boundary sets (spec `y3d.md` 1.6): a given velocity, or force and acceleration.
pub(super) fn read(reader: &mut Reader<'_>) -> Vec<NodeSet<3>> {
    let len = reader.count_of_sets("YDB/NBCON", "YDB/MBCON", "boundary sets", 0);
    for (k, name) in CODES.into_iter().enumerate() {
        let code = reader.integers(name, 0);
        if let Some(found) = Offenders::find(len, |set| !(0..=1).contains(&code(set))) {
            let value = code(found.first);
            let what = if value == 2 { ": a harmonic velocity (VGW)" } else { "" };
            reader.report(
                Diagnostic::error(
                    "scene::not-simulated",
                    format!(
                        "code {value} of boundary set {} is not simulated{what}{}",
                        found.first,
                        found.more()
                    ),
                )
                .at(reader.entry(name, found.first))
                .expected(format!("0 (free) or 1 (the velocity {})", VELOCITIES[k]))
                .help("in Solidity all codes but 0 give the velocity: write 1 if that is meant"),
            );
        }
    }
    let codes: [_; 3] = CODES.map(|name| reader.integers(name, 0));
    let [velocities, forces, accelerations] =
        [VELOCITIES, FORCES, ACCELERATIONS].map(|names| names.map(|name| reader.reals(name, 0.0)));
    (0..len)
        .map(|set| {
            let is_given = |k: usize| codes[k](set) != 0;
            NodeSet {
                conditions: std::array::from_fn(|k| {
                    if is_given(k) { Condition::Velocity } else { Condition::Force }
                }),
                amplitudes: std::array::from_fn(|k| {
                    if is_given(k) { velocities[k](set) } else { forces[k](set) }
                }),
                acceleration: std::array::from_fn(|k| accelerations[k](set)),
                pressure: 0.0,
                traction: 0.0,
                edge_factor: 1.0,
                edge_factor_step: 0.0,
                axes: SMatrix::identity(),
                moves: true,
            }
        })
        .collect()
}

/// Reports nodes of sets that do not exist.
pub(super) fn check_sets(reader: &mut Reader<'_>, nodes: &Nodes<3>, sets: usize) {
    let missing = |n: usize| usize::try_from(nodes.set[n]).map_or(true, |set| set >= sets);
    if let Some(found) = Offenders::find(nodes.len(), missing) {
        reader.report(
            Diagnostic::error(
                "scene::node-set",
                format!(
                    "node {} has boundary set {}, which does not exist{}",
                    found.first,
                    nodes.set[found.first],
                    found.more()
                ),
            )
            .at(reader.entry("YDN/I1NOPR", found.first))
            .expected(if sets == 0 {
                "boundary sets: /YD/YDB/MBCON, NBCON and their arrays".to_owned()
            } else {
                format!("a boundary set: {}", super::super::reader::numbers_of(sets))
            })
            .help("sets are numbered from 0 in .Y3D decks"),
        );
    }
}
