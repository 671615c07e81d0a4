use super::{Reader, solids};
use crate::{
    mechanics::Vec2,
    scene::{Insertion, Probe, ProbeQuantity, Scene},
};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

/// Type of the kinetic energy, the only one of the classic dialect.
const KINETIC_ENERGY: i64 = 15;

pub(super) fn read(reader: &mut Reader<'_>, dimension: usize) -> (Vec<Probe>, f64) {
    let len = reader.count("YDO/NOHYS", "YDO/MOHYS", "histories", 0);
    let threshold = reader.real("YDO/DOHYP");
    if len == 0 {
        return (Vec::new(), threshold);
    }
    let what = "histories";
    let kinds = reader.required_integers("YDO/I1OHYT", what, len);
    let time_factor = reader.required_reals("YDO/D1OHYC", what, len);
    let value_factor = reader.required_reals("YDO/D1OHYF", what, len);
    let (Some(kinds), Some(time_factor), Some(value_factor)) = (kinds, time_factor, value_factor)
    else {
        return (Vec::new(), threshold);
    };
    let initial = reader.reals("YDO/D1OHYS", 0.0);
    let initial_time = reader.reals("YDO/D1OHYT", 0.0);
    let (x, y) = (reader.reals("YDO/D1OHYX", 0.0), reader.reals("YDO/D1OHYY", 0.0));
    let probes = (0..len).map(|i| Probe {
        quantity: if dimension == 3 {
            solids::quantity(reader, i, kinds.get1(i))
        } else {
            quantity(reader, i, kinds.get1(i))
        },
        point: [x(i), y(i)],
        initial_value: initial(i),
        initial_time: initial_time(i),
        time_factor: time_factor.get1(i),
        value_factor: value_factor.get1(i),
    });
    (probes.collect(), threshold)
}

fn quantity(reader: &mut Reader<'_>, history: usize, code: i64) -> ProbeQuantity {
    if reader.is_classic() && code != KINETIC_ENERGY {
        reader.report(
            Diagnostic::note(
                "scene::history-type",
                format!("history {history} has type {code}, which this dialect never updates"),
            )
            .at(reader.entry("YDO/I1OHYT", history))
            .expected("15, the kinetic energy")
            .help("as in the original its file has only the line of the first step"),
        );
        return ProbeQuantity::NeverUpdated(code);
    }
    match code {
        1 => ProbeQuantity::StressXx,
        2 => ProbeQuantity::StressXy,
        3 => ProbeQuantity::StressYy,
        4..=6 => ProbeQuantity::StressOutOfPlane,
        7 => ProbeQuantity::Speed,
        8 => ProbeQuantity::VelocityX,
        9 => ProbeQuantity::VelocityY,
        KINETIC_ENERGY => ProbeQuantity::KineticEnergy,
        21 if reader.database.dialect() == Dialect::YGeo => ProbeQuantity::StrainEnergy,
        18 => ProbeQuantity::ForceX,
        19 => ProbeQuantity::ForceY,
        _ => {
            reader.report(
                Diagnostic::warning(
                    "scene::history-type",
                    format!("history {history} has type {code}, which is never updated"),
                )
                .at(reader.entry("YDO/I1OHYT", history))
                .expected(
                    "1 σxx, 2 σxy, 3 σyy, 7 speed, 8 vx, 9 vy, 15 kinetic energy, 18 force x or 19 force y",
                ),
            );
            ProbeQuantity::NeverUpdated(code)
        }
    }
}

/// Reports histories whose point lies nowhere.
pub(super) fn check_use(reader: &mut Reader<'_>, scene: &Scene) {
    // where nodes and elements will be is not known yet
    if scene.insertion.as_ref().is_some_and(Insertion::changes_mesh) {
        return;
    }
    for (history, probe) in scene.probes.iter().enumerate() {
        let point = Vec2::from(probe.point);
        let found = match probe.quantity {
            ProbeQuantity::ForceX | ProbeQuantity::ForceY => scene.nodes.initial.contains(&point),
            quantity if quantity.is_elemental() => scene.contains_point(point),
            _ => true,
        };
        if !found {
            let place =
                if probe.quantity.is_elemental() { "in no elastic triangle" } else { "at no node" };
            reader.report(
                Diagnostic::warning(
                    "scene::history-point",
                    format!("history {history} lies {place}: ({}, {})", point.x, point.y),
                )
                .at(reader.entry("YDO/D1OHYX", history))
                .expected("initial coordinates strictly inside a triangle, or exactly those of a node for forces")
                .help("its value stays what D1OHYS gives"),
            );
        }
    }
}
