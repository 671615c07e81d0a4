//! A wall of bricks and mortar that is pushed at its top.

use crate::{Bench, Case, CaseError, Finding, Group, InSpace, Outcome, case::Figure, measure};
use std::{collections::BTreeSet, ops::ControlFlow};
use ypsilon::{
    meshing::{
        Scenario,
        spatial::{SpatialMesh, kinds::Wall3d},
    },
    scene::{PressedFaces, Profile, SpatialContact},
    simulation::SpatialSimulation,
};
use ypsilon_post::plot::{SolidOptions, solid};

/// The case.
pub const CASE: Case = Case {
    name: "wall-3d",
    group: Group::Solids,
    title: "Mortared wall of a thousand bricks, pushed at its top",
    source: "mechanics: weight, strength, friction; cost beside that of triangles",
    about: "\
A wall of two leaves in running bond, 4 m long, 1.5 m high, 0.2 m thick: 1025 bricks of 0.2 × 0.1 × 0.06 m,
twelve tetrahedra each, with joints between all of them: mortar between bricks, stone inside. It settles under
its weight; then half a metre of the top is driven across. Mortar tears around it and along the bed above the
clamped base.

Nodes are not flagged as boundary nodes (`contact_at_cracks`), and the run follows the published source
(`--profile source`): faces touch each other where a joint between them has failed, with friction
(`--contact-friction`), and contact costs nothing elsewhere.",
    evaluate,
};

/// Friction, and the original's normal force.
const HOW: InSpace = InSpace {
    contact: SpatialContact { pressed: PressedFaces::Contactor, has_friction: true },
    profile: Profile::Source,
};

/// Joint sets of the generator: inside bricks, and mortar.
const INSIDE: usize = 0;
const MORTAR: usize = 1;

/// What the wall is like before it is pushed.
struct Rest {
    /// Force on the base by the weight above it.
    borne: f64,
    /// Root mean square of the velocities \[m/s\].
    speed: f64,
    failed: usize,
}

impl Rest {
    fn new(simulation: &SpatialSimulation, gravity: f64) -> Self {
        let places = &simulation.scene().nodes.initial;
        let base: Vec<usize> = (0..places.len()).filter(|&n| places[n][2] == 0.0).collect();
        let force = |n: usize| simulation.forces()[n][2] + simulation.joint_forces()[n][2];
        let borne: f64 = base.iter().map(|&n| -force(n)).sum();
        let fixed = measure::mass(simulation, base);
        let whole = measure::mass(simulation, 0..places.len());
        Self {
            borne: borne / ((whole - fixed) * gravity.abs()),
            speed: (2.0 * measure::kinetic_energy(simulation) / whole).sqrt(),
            failed: simulation.failures().len(),
        }
    }
}

/// Displacement across the wall of the middle of a tetrahedron \[m\].
fn across(simulation: &SpatialSimulation, element: usize) -> f64 {
    let nodes = &simulation.scene().nodes;
    let corners = simulation.scene().elements.corners::<4>(element);
    corners.iter().map(|&n| nodes.current[n][1] - nodes.initial[n][1]).sum::<f64>() / 4.0
}

fn draw(
    bench: &Bench,
    simulation: &SpatialSimulation,
    file: &str,
    caption: &str,
    (quantity, unit, range): (&str, &str, Option<[f64; 2]>),
    value: impl Fn(usize) -> f64,
) -> Result<Figure, CaseError> {
    let options = SolidOptions {
        title: format!("{caption}, t = {:.3} s", simulation.time()),
        quantity: quantity.to_owned(),
        unit: unit.to_owned(),
        range,
        from_deg: [155.0, 20.0],
        width: 1200,
    };
    bench.picture(&solid(&measure::solid(simulation, value), &options)?, file, caption)
}

/// Number of failed joints at each tetrahedron.
fn failed_at(simulation: &SpatialSimulation) -> Vec<f64> {
    let elements = &simulation.scene().elements;
    let mut count = vec![0.0; elements.len()];
    for failure in simulation.failures() {
        for side in
            elements.sides[failure.element].into_iter().filter_map(|e| usize::try_from(e).ok())
        {
            count[side] += 1.0;
        }
    }
    count
}

/// Bricks beside failed mortar.
fn bricks_at_cracks(simulation: &SpatialSimulation, mesh: &SpatialMesh) -> usize {
    let elements = &simulation.scene().elements;
    let mortar = simulation.failures().iter().filter(|failure| failure.law == MORTAR);
    let sides = mortar.flat_map(|failure| elements.sides[failure.element]);
    let brick = |e: i32| Some(mesh.tetrahedra.get(usize::try_from(e).ok()?)?.block);
    sides.filter_map(brick).collect::<BTreeSet<_>>().len()
}

fn wall_of<'a>(bench: &Bench, scenario: &'a mut Scenario) -> Result<&'a Wall3d, CaseError> {
    let missing = || CaseError::missing("the scenario has no [wall_3d]");
    let wall = scenario.wall_3d.as_mut().ok_or_else(missing)?;
    if bench.pick(false, true) {
        *wall = Wall3d { bricks: 4, courses: 4, push_width_m: 0.3, push_s: 0.01, ..wall.clone() };
    }
    Ok(wall)
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let wall = wall_of(bench, &mut scenario)?.clone();
    let mesh = wall.model()?.mesh;
    let mut rest = None;
    let mut figures = Vec::new();
    let mut fault = None;
    let done = bench.watch_in_space(&scenario, "wall", HOW, |simulation| {
        if rest.is_none() && simulation.time() >= wall.settle_s {
            rest = Some(Rest::new(simulation, wall.gravity_m_s2));
            let shown = ("−σzz", "Pa", Some([0.0, 60e3]));
            let stress = |e: usize| -simulation.stress(e)[(2, 2)];
            match draw(bench, simulation, "settled.png", "At rest under its weight", shown, stress)
            {
                Ok(figure) => figures.push(figure),
                Err(error) => fault = Some(error),
            }
        }
        ControlFlow::Continue(())
    })?;
    if let Some(error) = fault {
        return Err(error);
    }
    let (Some(rest), false) = (rest, done.is_unstable) else {
        return Err(CaseError::missing("the wall has become unstable"));
    };
    let simulation = &done.simulation;
    let failed = failed_at(simulation);
    let shown = ("across", "m", None);
    let by_element = |e: usize| across(simulation, e);
    figures.push(draw(bench, simulation, "pushed.png", "Pushed at its top", shown, by_element)?);
    let shown = ("failed joints", "", Some([0.0, 2.0]));
    figures.push(draw(
        bench,
        simulation,
        "cracks.png",
        "Cracks: joints that have failed at each tetrahedron",
        shown,
        |e| failed[e],
    )?);
    let of_law = |law| simulation.failures().iter().filter(|failure| failure.law == law).count();
    let (mortar, inside) = (of_law(MORTAR), of_law(INSIDE));
    let bricks = bricks_at_cracks(simulation, &mesh);
    let farthest = simulation.tetrahedra().map(|e| across(simulation, e)).fold(0.0, f64::max);
    let way = wall.push_m_s[1] * 0.95 * wall.push_s;
    let rate = mesh.tetrahedra.len() as f64 * simulation.step_index() as f64 / done.seconds;
    let contacts = simulation.couple_work().map_or(0, |work| work.most_couples);
    let findings = vec![
        Finding::range(
            "bricks",
            "",
            bench.pick([1000.0, 1100.0], [8.0, 100.0]),
            mesh.blocks as f64,
        ),
        Finding::value("weight at the base, at rest", "", 1.0, rest.borne, 0.02),
        Finding::within("root mean square of velocities, at rest", "m/s", 0.0, rest.speed, 1e-3),
        Finding::within("failed joints, at rest", "", 0.0, rest.failed as f64, 0.0),
        Finding::range("farthest tetrahedron, pushed", "m", [0.8 * way, 1.2 * way], farthest),
        Finding::statement(
            "failed joints, pushed",
            "mortar above all, stone where cracks cross bricks",
            &format!("{mortar} of mortar, {inside} inside bricks; cracks at {bricks} bricks"),
            mortar > inside && bench.pick(2 * bricks < mesh.blocks, true),
        ),
        Finding::range("most couples in contact lists", "", [1.0, 1e6], contacts as f64),
        Finding::told(
            "tetrahedron-steps per second, with 1.8 joints a tetrahedron",
            "1/s",
            25e6,
            rate,
            "beside triangle-steps of a jointed sheet on one core; depends on the machine",
        ),
    ];
    Ok(Outcome { findings, pictures: figures })
}
