//! The thinnest semicircular arch.

use super::arch_limit::semicircle;
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome, measure,
    plotting::{chart, line},
};
use std::{collections::VecDeque, ops::ControlFlow};
use ypsilon::{meshing::Scenario, simulation::Simulation};
use ypsilon_post::{
    field::Field,
    plot::{ContourOptions, JointLines, contour},
    results::Frame,
};

/// The case.
pub const CASE: Case = Case {
    name: "semicircular-arch",
    group: Group::Classical,
    title: "Limit thickness of a semicircular arch",
    source: "M. Milankovitch, Z. Math. Phys. 55 (1907) 1-27; J. Heyman, Int. J. Solids Struct. 5 \
             (1969) 363-379; J. A. Ochsendorf, Struct. Eng. 84 (2006) 49-51",
    about: "\
A semicircle of 20 equal dry voussoirs (centre line of radius R = 1 m, joints every 9°, one at the
crown) with friction too high to slip, under its own weight. Rigid voussoirs without tension stand
if a line of thrust fits into them: t/R ≥ 0.1074 (Milankovitch, with the true centres of gravity;
Heyman's simpler 0.106). At the limit five hinges open: at the extrados at the crown and at both
springings, at the intrados 54.5° from the crown. With joints every 9° the intrados hinges lie
at 54°, and limit analysis of these very voussoirs (`arch_limit.rs`) gives their own limit.

The weight comes at once. Voussoirs and contacts are not rigid: at a hinge the force needs a zone of
some width, so that the arch acts a little thinner than it is, and it swings into place. The limit
found is therefore above that of rigid voussoirs, the more so the softer they are.",
    evaluate,
};

/// How an arch fares.
struct Fate {
    /// Whether it collapsed.
    falls: bool,
    /// Drop of the crown by the radius through time.
    drop: Vec<[f64; 2]>,
    /// Joints that opened when the crown had dropped by 4 % of the radius: angle from the crown,
    /// and whether the hinge is at the extrados.
    hinges: Vec<(f64, bool)>,
    /// What it looked like when its end was clear.
    frame: Frame,
}

/// Drop of the crown at which an arch counts as collapsed, by the radius.
const COLLAPSED: f64 = 0.12;

/// An arch whose crown moves by less than this part of the radius for so long \[s\] stands. One
/// that lacks a hundredth of its equilibrium would move by four times as much.
const STILL: f64 = 1e-4;
const REST: f64 = 0.3;

fn fate(bench: &Bench, scenario: &Scenario, name: &str) -> Result<Fate, CaseError> {
    let arch = scenario.arch.as_ref();
    let arch = arch.ok_or_else(|| CaseError::missing("the scenario has no [arch]"))?;
    let crown = arch.model()?.top;
    let of_block = (arch.cells[0] + 1) * (arch.cells[1] + 1);
    let mut drop = Vec::new();
    let mut hinges = Vec::new();
    let mut recent = VecDeque::new();
    let done = bench.watch(scenario, name, |simulation| {
        if !simulation.step_index().is_multiple_of(50) {
            return ControlFlow::Continue(());
        }
        let nodes = &simulation.scene().nodes;
        let down = |n: &usize| nodes.initial[*n][1] - nodes.current[*n][1];
        let sag = crown.iter().map(down).sum::<f64>() / crown.len() as f64 / arch.radius_m;
        drop.push([simulation.time(), sag]);
        if hinges.is_empty() && sag > 0.04 {
            hinges = open_joints(simulation, arch.voussoirs, of_block, arch.cells[0]);
        }
        let time = simulation.time();
        while recent.front().is_some_and(|(t, _)| *t < time - REST) {
            recent.pop_front();
        }
        recent.push_back((time, sag));
        let moved = recent.iter().map(|(_, other)| (other - sag).abs()).fold(0.0, f64::max);
        let rests = time > REST && moved < STILL;
        if sag > COLLAPSED || rests { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let falls = drop.last().is_some_and(|last| last[1] > COLLAPSED);
    Ok(Fate { falls, drop, hinges, frame: measure::frame(&done.simulation) })
}

/// Joints whose sides turn against each other by more than a quarter of what the most open one
/// does.
fn open_joints(
    simulation: &Simulation,
    voussoirs: usize,
    of_block: usize,
    along: usize,
) -> Vec<(f64, bool)> {
    let nodes = &simulation.scene().nodes;
    let first = nodes.initial.len() - voussoirs * of_block;
    let turn = |k: usize| {
        let (a, b) = (first + k * of_block, first + k * of_block + along);
        let angle = |places: &[ypsilon::mechanics::Vec2]| {
            let d = places[b] - places[a];
            d[1].atan2(d[0])
        };
        angle(&nodes.current) - angle(&nodes.initial)
    };
    // the held blocks do not turn
    let turns: Vec<f64> = std::iter::once(0.0)
        .chain((0..voussoirs).map(turn))
        .chain(std::iter::once(0.0))
        .map(|t| t - std::f64::consts::TAU * (t / std::f64::consts::TAU).round())
        .collect();
    let opening: Vec<f64> = turns.windows(2).map(|w| w[1] - w[0]).collect();
    let most = opening.iter().fold(0.0_f64, |m, o| m.max(o.abs()));
    let angle = |k: usize| 180.0 * k as f64 / voussoirs as f64 - 90.0;
    let open = opening.iter().enumerate().filter(|(_, o)| o.abs() > 0.25 * most);
    open.map(|(k, o)| (angle(k), *o > 0.0)).collect()
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut tried = |thickness: f64, young: f64| -> Result<Fate, CaseError> {
        let arch = scenario.arch.as_mut();
        let arch = arch.ok_or_else(|| CaseError::missing("the scenario has no [arch]"))?;
        arch.thickness_m = thickness * arch.radius_m;
        arch.stone.young_pa = young;
        arch.stone.penalty_pa = 2.0 * young;
        arch.stone.tangential_penalty_pa = young;
        fate(bench, &scenario, &format!("t{thickness}-{young:e}"))
    };
    let mut findings = Vec::new();
    let exact = semicircle(20);
    let [thinnest, thickest] = [0.100, 0.125];
    let soft = 2e9;
    let thin = tried(thinnest, soft)?;
    let thick = tried(thickest, soft)?;
    let said = |falls: bool| if falls { "falls" } else { "stands" };
    findings.push(Finding::statement("t/R = 0.100", "falls", said(thin.falls), thin.falls));
    findings.push(Finding::statement("t/R = 0.125", "stands", said(thick.falls), !thick.falls));
    let mut lines = vec![
        line("t/R = 0.100, E = 2 GPa", thin.drop.clone()),
        line("t/R = 0.125, E = 2 GPa", thick.drop.clone()),
    ];
    let stiffest = 32e9;
    for young in bench.pick(vec![soft, 8e9, stiffest], Vec::new()) {
        let (mut falls, mut stands) = (thinnest, thickest);
        for _ in 0..5 {
            let thickness = f64::midpoint(falls, stands);
            let found = tried(thickness, young)?;
            if young == stiffest {
                lines.push(line(&format!("t/R = {thickness:.4}, E = 32 GPa"), found.drop));
            }
            *(if found.falls { &mut falls } else { &mut stands }) = thickness;
        }
        let limit = f64::midpoint(falls, stands);
        let name = format!("limit of t/R, E = {} GPa", young / 1e9);
        let bracket = format!("t/R = {falls:.4} falls and {stands:.4} stands");
        if young == stiffest {
            findings.push(Finding::value(&name, "", 0.1074, limit, 0.04).noted(bracket));
            let name = format!("{name}; expected: these voussoirs, if rigid");
            findings.push(Finding::value(&name, "", exact.thickness, limit, 0.04));
        } else {
            let reason = "too soft for rigid voussoirs, shows the convergence";
            findings.push(Finding::told(&name, "", 0.1074, limit, reason).noted(bracket));
        }
    }
    let name = "intrados hinge from the crown by limit analysis of these voussoirs";
    findings.push(Finding::within(name, "°", 54.5, exact.intrados_deg, 4.5));
    let found = |outer: bool, range: [f64; 2]| -> Vec<f64> {
        let kind = thin.hinges.iter().filter(|h| h.1 == outer).map(|h| h.0.abs());
        kind.filter(|a| (range[0]..=range[1]).contains(a)).collect()
    };
    let mean = |angles: &[f64]| angles.iter().sum::<f64>() / angles.len() as f64;
    let inner = found(false, [0.0, 90.0]);
    let name = "intrados hinges from the crown (mean; joints every 9°)";
    findings.push(Finding::within(name, "°", 54.5, mean(&inner), 9.0));
    let seen: Vec<String> = thin
        .hinges
        .iter()
        .map(|(a, outer)| format!("{a:.0}° {}", if *outer { "extrados" } else { "intrados" }))
        .collect();
    let holds = !found(true, [0.0, 9.0]).is_empty()
        && found(true, [80.0, 90.0]).len() >= 2
        && inner.iter().all(|a| (40.0..70.0).contains(a));
    findings.push(Finding::statement(
        "hinges of the falling arch",
        "extrados at the crown and at both springings, intrados between",
        &seen.join(", "),
        holds,
    ));
    let title = "Drop of the crown";
    let picture = chart(title, ["time (s)", "drop by R"], &lines)?;
    let mut pictures =
        vec![bench.picture(&picture, "drop.png", "Drop of the crown through time")?];
    let options = ContourOptions {
        width: 700,
        joints: JointLines::None,
        title: Some("t/R = 0.100, five hinges".to_owned()),
        ..ContourOptions::new(Field::Displacement)
    };
    let picture = contour(&thin.frame, &options)?;
    pictures.push(bench.picture(&picture, "collapse.png", "The arch of t/R = 0.100 falls")?);
    Ok(Outcome { findings, pictures })
}
