//! Scenes at rest: settled, and waited for.

use ypsilon::{
    mechanics::triangle::double_area,
    meshing::Scenario,
    scene::{Condition, ElementKind, Scene},
    simulation::{Settled, SettlingFault, SettlingOptions, SettlingOutcome, Simulation},
};

/// The scene of a scenario, with the damping multiplied.
pub fn scene_of(scenario: &str, damping: f64) -> Scene {
    let generated = Scenario::parse(scenario).and_then(|s| s.generate()).expect("a sound scenario");
    let mut scene = super::scenes::scene(&generated.deck);
    scene.materials.iter_mut().for_each(|m| m.viscosity *= damping);
    scene
}

/// A scene before its first step.
pub fn prepared(scene: &Scene) -> Simulation {
    let mut simulation = Simulation::new(scene.clone());
    simulation.prepare().expect("the deck leaves room for its joints");
    simulation
}

/// Settles a scene.
pub fn settle(
    simulation: &mut Simulation,
    options: SettlingOptions,
) -> Result<Settled, SettlingFault> {
    match simulation.settle(options, &mut |_| true)? {
        SettlingOutcome::Settled(settled) => Ok(settled),
        SettlingOutcome::Stopped => panic!("nobody stopped it"),
    }
}

/// A scene brought to rest, its forces evaluated as the first step does.
pub fn settled(scene: &Scene) -> (Simulation, Settled) {
    let mut simulation = prepared(scene);
    let settled = settle(&mut simulation, SettlingOptions::default())
        .unwrap_or_else(|fault| panic!("{fault}"));
    simulation.evaluate_forces();
    (simulation, settled)
}

/// Runs a scene until its kinetic energy is nothing against the largest that it has had, gravity
/// growing in `rise` steps; the steps that it took.
pub fn waited(scene: &Scene, rise: u64) -> (Simulation, u64) {
    /// Steps between two looks, and with one gravity.
    const INTERVAL: u64 = 50;
    const MOST: u64 = 2_000_000;
    let mut simulation = prepared(scene);
    let gravity = scene.control.gravity;
    let mut largest: f64 = 0.0;
    let mut steps = 0;
    while steps < MOST {
        if steps <= rise + INTERVAL && rise > 0 {
            let t = (steps as f64 / rise as f64).min(1.0);
            let mut scene = simulation.scene().clone();
            scene.control.gravity[1] = gravity[1] * t * t * (3.0 - 2.0 * t);
            scene.control.first_step = simulation.step_index();
            scene.control.start_time = simulation.time();
            simulation.continue_with(scene, None);
        }
        for _ in 0..INTERVAL {
            simulation.evaluate_forces();
            simulation.advance();
        }
        steps += INTERVAL;
        let energy = simulation.sum_kinetic_energy();
        largest = largest.max(energy);
        if steps > rise && energy < 1e-11 * largest {
            break;
        }
    }
    assert!(steps < MOST, "it does not come to rest");
    simulation.evaluate_forces();
    (simulation, steps)
}

/// Unbalanced force ratio under gravity and forces of node sets that are free along the global
/// axes or held, from the forces of the last evaluation.
pub fn ratio(simulation: &Simulation) -> f64 {
    let scene = simulation.scene();
    let (mut largest, mut loads, mut count): (f64, f64, f64) = (0.0, 0.0, 0.0);
    for n in 0..scene.nodes.len() {
        let Some(set) =
            usize::try_from(scene.nodes.set[n]).ok().and_then(|s| scene.node_sets.get(s))
        else {
            continue;
        };
        let mass = simulation.masses()[n];
        let free = set.conditions.map(|c| c == Condition::Force);
        if !set.moves || mass <= 0.0 || free == [false; 2] {
            continue;
        }
        let apart = simulation.contact_forces().get(n).copied().unwrap_or_default();
        let internal = simulation.forces()[n] + apart;
        let load = [set.amplitudes[0], set.amplitudes[1] + scene.control.gravity[1] * mass];
        let part = |k: usize| if free[k] { [internal[k] + load[k], load[k]] } else { [0.0; 2] };
        let [x, y] = [part(0), part(1)];
        largest = largest.max(x[0].hypot(y[0]));
        loads += x[1].hypot(y[1]);
        count += 1.0;
    }
    largest / (loads / count)
}

/// Triangles with stress: σxx, σxy, σyy, area and middle.
pub fn stresses(simulation: &Simulation) -> Vec<([f64; 3], f64, [f64; 2])> {
    let scene = simulation.scene();
    let elastic =
        |e: &usize| scene.material_of(*e).is_some_and(|m| m.kind == ElementKind::ElasticTriangle);
    let of = |e: usize| {
        let s = simulation.stresses()[e];
        let corners = scene.elements.corners::<3>(e).map(|n| scene.nodes.current[n]);
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        ([s[(0, 0)], s[(0, 1)], s[(1, 1)]], double_area(&corners) / 2.0, [middle.x, middle.y])
    };
    (0..scene.elements.len()).filter(elastic).map(of).collect()
}

/// The largest difference of σyy between two states of a scene, relative to the largest σyy.
pub fn difference(a: &Simulation, b: &Simulation) -> f64 {
    let (a, b) = (stresses(a), stresses(b));
    assert_eq!(a.len(), b.len());
    let largest = a.iter().map(|t| t.0[2].abs()).fold(0.0, f64::max);
    let worst = a.iter().zip(&b).map(|(a, b)| (a.0[2] - b.0[2]).abs()).fold(0.0, f64::max);
    worst / largest
}
