//! The balance of energies: closed scenes conserve, each channel of loss takes what the motion
//! loses, and watching changes nothing.

mod support;

use assert_cmd::Command;
use std::fs;
use support::{
    spoilt_deck::{edited, write},
    stability_scenes::{Body, Moving},
};
use tempfile::TempDir;
use ypsilon::simulation::{EnergyBalance, PlaneAudit, SpaceAudit};

/// What an audited run came to.
struct Audited {
    first: EnergyBalance,
    last: EnergyBalance,
    worst: f64,
    /// The most that overlaps stored.
    most_in_contact: f64,
}

/// Runs so many steps of a length and watches all of them.
fn audited(moving: &mut Moving, dt: f64, steps: usize) -> Audited {
    moving.run(dt, 0);
    let mut balances = Vec::with_capacity(steps);
    let worst = match moving {
        Moving::Plane(simulation) => {
            simulation.watch_contact_forces();
            simulation.keep_triangles();
            let mut audit = PlaneAudit::new(simulation);
            for _ in 0..steps {
                simulation.evaluate_forces();
                audit.after_forces(simulation);
                simulation.advance();
                audit.after_motion(simulation);
                balances.push(audit.ledger().balance());
            }
            audit.ledger().worst_error()
        }
        Moving::Space(simulation) => {
            let mut audit = SpaceAudit::new();
            for _ in 0..steps {
                simulation.evaluate_forces();
                audit.after_forces(simulation);
                simulation.advance();
                audit.after_motion(simulation);
                balances.push(audit.ledger().balance());
            }
            audit.ledger().worst_error()
        }
    };
    Audited {
        first: balances[0],
        last: balances[steps - 1],
        worst,
        most_in_contact: balances.iter().map(|b| b.contact_stored).fold(0.0, f64::max),
    }
}

/// Free bodies that vibrate at half the critical step keep their energy to 1e-6. The error is about a
/// twentieth of the strain, `speed` by 1 m/s: works by the mean of forces are exact for linear ones.
fn conserves(body: &Body, speed: f64, steps: usize) {
    let mut moving = body.simulation();
    moving.disturb(speed);
    let dt = 0.5 * moving.limits().critical_s;
    let run = audited(&mut moving, dt, steps);
    assert!(run.worst < 1e-6, "{:e}", run.worst);
    let energy = |b: &EnergyBalance| b.kinetic + b.strain + b.joint_recoverable;
    let kept = energy(&run.last) / energy(&run.first) - 1.0;
    // joints: what the parabola gives back is not quite what its tangent took
    assert!(kept.abs() < 1e-4, "{kept:e}");
    // the energy goes to and fro
    assert!(run.last.strain > 0.1 * run.last.kinetic);
}

#[test]
fn closed_scenes_conserve() {
    conserves(&Body::rectangle([4, 4], 1.0, 0.3), 1e-5, 20_000);
    conserves(&Body::block([1, 1, 2], 1.0), 1e-5, 20_000);
    let jointed = Body { joints: Some([1e5, 1e3]), ..Body::rectangle([2, 2], 1.0, 0.2) };
    conserves(&jointed, 1e-5, 20_000);
}

#[test]
#[ignore = "a minute: a million steps"]
fn closed_scenes_conserve_for_a_million_steps() {
    conserves(&Body::rectangle([4, 4], 1.0, 0.3), 1e-6, 1_000_000);
    conserves(&Body::block([1, 1, 2], 1.0), 1e-6, 1_000_000);
}

#[test]
fn viscosity_takes_what_the_vibration_loses() {
    for body in [Body::rectangle([3, 3], 1.0, 0.3), Body::block([1, 1, 2], 1.0)] {
        let mut moving = Body { viscosity: 200.0, ..body }.simulation();
        moving.disturb(1e-4);
        let dt = 0.2 * moving.limits().critical_s;
        let run = audited(&mut moving, dt, 20_000);
        let energy = |b: &EnergyBalance| b.kinetic + b.strain;
        let lost = energy(&run.first) - energy(&run.last);
        assert!(lost > 0.5 * energy(&run.first), "{lost:e}");
        assert!((run.last.viscous_dissipated / lost - 1.0).abs() < 1e-5);
        assert!(run.worst < 1e-5, "{:e}", run.worst);
        for other in [run.last.friction_dissipated, run.last.joint_dissipated] {
            assert!(other.abs() < 1e-9 * lost, "{:?}", run.last);
        }
    }
}

/// A body that falls freely gains what gravity brings in.
#[test]
fn external_work_is_that_of_gravity() {
    for body in [Body::rectangle([2, 2], 1.0, 0.0), Body::block([1, 1, 1], 1.0)] {
        let (dimension, mass) = (body.dimension, if body.dimension == 2 { 4e4 } else { 1e4 });
        let mut moving = Body { gravity: -9.81, ..body }.simulation();
        let (dt, steps) = (0.1 * moving.limits().critical_s, 200);
        let run = audited(&mut moving, dt, steps);
        // the first step is in the balance at rest: x_n = g dt² n(n+1)/2
        let fall = 9.81 * dt * dt * (steps * (steps - 1)) as f64 / 2.0;
        let expected = mass * 9.81 * fall;
        let work = run.last.external_work;
        assert!((work / expected - 1.0).abs() < 1e-9, "{dimension}D: {work} {expected}");
        assert!((run.last.kinetic - run.first.kinetic) / work - 1.0 < 1e-9);
        assert!(run.worst < 1e-9, "{:e}", run.worst);
    }
}

/// What moves a body with a prescribed velocity does the work that stretches it.
#[test]
fn supports_do_the_work_that_stretches_a_body() {
    let mut body = Body { viscosity: 500.0, ..Body::rectangle([2, 6], 1.0, 0.0) };
    body = body.put(1, 0.0..=0.0).put(2, 6.0..=6.0);
    body.load = 100.0;
    let mut moving = body.simulation();
    let dt = 0.2 * moving.limits().critical_s;
    let run = audited(&mut moving, dt, 20_000);
    let b = run.last;
    assert!(b.external_work > 0.0);
    let found = b.kinetic + b.strain + b.viscous_dissipated;
    assert!((found / b.external_work - 1.0).abs() < 1e-3, "{b:?}");
    assert!(run.worst < 1e-3, "{:e}", run.worst);
}

/// Two bodies collide and part: overlaps store energy and give it back.
#[test]
fn contact_stores_energy_and_gives_it_back() {
    let mut body = Body { penalty: 1e5, ..Body::rectangle([2, 2], 1.0, 0.0) };
    body.add_rectangle([0.3, 2.01], [2, 2], 1.0, 0.0);
    let mut moving = body.simulation();
    moving.push(|n, _| [0.0, if n < 9 { 1e-2 } else { -1e-2 }, 0.0]);
    let dt = 0.05 * moving.limits().impact_s;
    let run = audited(&mut moving, dt, (30.0 / dt) as usize);
    assert!(run.most_in_contact > 0.05 * run.first.kinetic, "{:e}", run.most_in_contact);
    assert!(run.last.contact_stored < 1e-9 * run.first.kinetic, "{:?}", run.last);
    assert!(run.worst < 1e-3, "{:e}", run.worst);
    assert_eq!(run.last.friction_dissipated, 0.0);
}

/// A block slides on a base until friction has taken its energy: the force μ N by the way.
#[test]
fn friction_takes_what_sliding_loses() {
    let (friction, gravity, speed) = (0.5, 0.01, 0.1);
    let mut body = Body {
        penalty: 1e6,
        friction,
        gravity: -gravity,
        viscosity: 2e3,
        ..Body::rectangle([6, 1], 1.0, 0.0)
    };
    body.sets.fill(1);
    body.add_rectangle([1.0, 1.0], [1, 1], 1.0, 0.0);
    let mut moving = body.simulation();
    // its weight comes to bear before it is pushed
    let dt = 0.2 * moving.limits().critical_s;
    moving.run(dt, (60.0 / dt) as usize);
    moving.push(|_, _| [speed, 0.0, 0.0]);
    let place = |moving: &Moving| match moving {
        Moving::Plane(s) => s.scene().nodes.current[14..].iter().map(|p| p.x).sum::<f64>() / 4.0,
        Moving::Space(_) => panic!("a scene in the plane"),
    };
    let start = place(&moving);
    let run = audited(&mut moving, dt, (40.0 / dt) as usize);
    let way = place(&moving) - start;
    let lost = run.first.kinetic - run.last.kinetic;
    let taken = run.last.friction_dissipated;
    assert!(lost > 0.99 * run.first.kinetic, "{:?} {:?}", run.first, run.last);
    assert!((taken / lost - 1.0).abs() < 0.05, "{taken} of {lost}: {:?}", run.last);
    let expected = friction * gravity * 1e4 * way;
    assert!((taken / expected - 1.0).abs() < 0.05, "{taken} against {expected}");
    assert!((way - speed * speed / (2.0 * friction * gravity)).abs() < 0.05, "{way}");
    assert!(run.worst < 1e-2, "{:e}", run.worst);
}

/// A joint that breaks takes its fracture energy.
#[test]
fn a_joint_that_breaks_takes_its_energy() {
    // a square of two triangles that fly apart across their joint
    let strength = 20.0;
    let body = Body { joints: Some([1e5, strength]), ..Body::rectangle([1, 1], 1.0, 0.0) };
    let mut moving = body.simulation();
    let Moving::Plane(simulation) = &moving else { panic!("a scene in the plane") };
    let upper: Vec<bool> = {
        let scene = simulation.scene();
        let second = scene.elements.corners::<3>(1);
        (0..scene.nodes.len()).map(|n| second.contains(&n)).collect()
    };
    moving.push(|n, _| if upper[n] { [-1.0, 1.0, 0.0] } else { [1.0, -1.0, 0.0] });
    let dt = 0.05 * moving.limits().critical_s;
    let run = audited(&mut moving, dt, (20.0 / dt) as usize);
    let Moving::Plane(simulation) = &moving else { panic!("a scene in the plane") };
    assert_eq!(simulation.failures().len(), 1);
    let energy = |b: &EnergyBalance| b.kinetic + b.strain;
    let lost = energy(&run.first) - energy(&run.last);
    assert!(lost > 0.0);
    assert!((run.last.joint_dissipated / lost - 1.0).abs() < 1e-3, "{:?} of {lost}", run.last);
    assert_eq!(run.last.joint_recoverable, 0.0);
    // the softening curve's area times the fracture energy, three times nominal, and the parabola
    let curve: f64 = {
        let steps = 10_000;
        let at = |i: i32| (f64::from(i) + 0.5) / f64::from(steps);
        (0..steps)
            .map(|i| ypsilon::mechanics::softening::remaining_strength(at(i)) / f64::from(steps))
            .sum()
    };
    let length = 2f64.sqrt();
    let peak = 2.0 * length * strength / 1e5;
    let nominal = length * (strength * peak * 2.0 / 3.0 + 3.0 * strength * curve);
    assert!((run.last.joint_dissipated / nominal - 1.0).abs() < 0.1, "{:?} {nominal}", run.last);
}

/// The run with the table of energies has the bits of the one without; the table and the summary
/// hold the balance.
#[test]
fn watching_changes_nothing() {
    let folder = TempDir::new().expect("a temporary folder");
    write(folder.path(), "deck.y", edited(&[]).as_bytes());
    let run = |more: &[&str], out: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
        let arguments =
            ["run", "deck.y", "--quiet", "--formats", "json", "--states", "20", "--out"];
        let output = command.current_dir(&folder).args(arguments).arg(out).args(more).output();
        let output = output.expect("the program starts");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let read = |name: &str| fs::read_to_string(folder.path().join(out).join(name));
        (read("deck.state_20.txt").expect("a state"), read("deck.run.json").expect("a summary"))
    };
    let (plain, summary) = run(&[], "plain");
    assert!(!summary.contains("\"energy\":"), "{summary}");
    let (watched, summary) = run(&["--energy=2"], "watched");
    assert_eq!(plain, watched);
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let balance = &summary["energy"]["last"];
    assert!(balance["external_work"].as_f64().expect("a number") != 0.0, "{balance}");
    let table = fs::read_to_string(folder.path().join("watched/deck.energy.csv")).expect("it");
    assert_eq!(table.lines().count(), 1 + 10);
    assert!(table.starts_with("time (s),step,kinetic (J),strain (J),"), "{table}");
    let last: Vec<f64> = table
        .lines()
        .last()
        .into_iter()
        .flat_map(|line| line.split(','))
        .map(|number| number.parse().expect("a number"))
        .collect();
    assert_eq!((last.len(), last[1]), (13, 18.0));
}
