//! What only Y-Geo has, against what must come out of it.

mod support;

use nalgebra::Vector2;
use support::{
    scenes::{scene, step},
    spoilt_deck::{Edits, base_of, edit},
};
use yformat::deck::Deck;
use ypsilon::{
    scene::JointKind,
    simulation::{Simulation, joint_views},
};

/// The square of two joined triangles after some edits, ready to run.
fn square(edits: Edits<'_>) -> Simulation {
    let deck = Deck::parse("square.y", edit(base_of("ygeo"), edits));
    assert!(!deck.has_errors(), "{:?}", deck.diagnostics);
    let mut simulation = Simulation::new(scene(&deck.deck));
    simulation.prepare().expect("room for the joint");
    simulation
}

/// The square as one body, without joint and gravity.
const ONE_BODY: [(&str, &str); 2] = [("1 1 3 0", "1 1 0 0"), ("DCGRAY -9.81", "DCGRAY 0")];

fn with<'a>(more: &[(&'a str, &'a str)]) -> Vec<(&'a str, &'a str)> {
    ONE_BODY.iter().chain(more).copied().collect()
}

fn run(simulation: &mut Simulation, steps: usize) {
    (0..steps).for_each(|_| step(simulation));
}

/// Cauchy stress of triangle 0 of the square stretched by 0.1 % along x.
fn stress_of_stretched(edits: &[(&str, &str)]) -> [f64; 3] {
    let stretched = "D2NCC 21 2 4\n0.0 0.0\n1.001 0.0\n1.001 1.0\n0.0 1.0";
    let plain = "D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0";
    let mut all = with(&[(plain, stretched), ("D1PEKS 1 1e3", "D1PEKS 1 0")]);
    all.extend(edits);
    let mut simulation = square(&all);
    simulation.evaluate_forces();
    let s = simulation.stresses()[0];
    [s[(0, 0)], s[(0, 1)], s[(1, 1)]]
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() <= tolerance, "{found} instead of {expected}");
}

/// σxx = E/(1−ν²) ε and σyy = ν σxx in plane stress; with (1−ν)/((1+ν)(1−2ν)) and ν/(1−ν) in plane
/// strain. The strain is ½(1.001² − 1).
#[test]
fn plane_stress_and_plane_strain_have_their_textbook_stresses() {
    let (young, poisson) = (2e9, 0.25);
    let strain = 0.5 * (1.001f64.powi(2) - 1.0);
    let [xx, xy, yy] = stress_of_stretched(&[("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 5")]);
    let expected = young / (1.0 - poisson * poisson) * strain;
    close(xx, expected, 1e-6 * expected);
    close(yy, poisson * expected, 1e-6 * expected);
    assert_eq!(xy, 0.0);
    let [xx, _, yy] = stress_of_stretched(&[("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 6")]);
    let expected = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)) * strain;
    close(xx, expected, 1e-6 * expected);
    close(yy, poisson / (1.0 - poisson) * expected, 1e-6 * expected);
}

/// Along the layers (x) and across them (y) the stiffness is that of the formulas of I1USAN.
#[test]
fn layered_material_is_stiff_along_its_layers() {
    let constants = [
        ("D1PEEX 1 0", "D1PEEX 1 4e9"),
        ("D1PEEY 1 0", "D1PEEY 1 1e9"),
        ("D1PEMX 1 0", "D1PEMX 1 0.3"),
        ("D1PEMY 1 0", "D1PEMY 1 0.1"),
        ("D1PEG 1 0", "D1PEG 1 1e9"),
    ];
    let strain = 0.5 * (1.001f64.powi(2) - 1.0);
    let mut first = constants.to_vec();
    first.push(("I1USAN 1 0", "I1USAN 1 1"));
    let [xx, _, yy] = stress_of_stretched(&first);
    let product = 1.0 - 0.3 * 0.1;
    close(xx, 4e9 / product * strain, 1.0);
    close(yy, 1e9 / product * 0.3 * strain, 1.0);
    let mut second = constants.to_vec();
    second.push(("I1USAN 1 0", "I1USAN 1 2"));
    let [xx, ..] = stress_of_stretched(&second);
    let (ex, x, y) = (4e9 / product, (0.3 + 0.03) / product, (0.1 + 0.03) / product);
    close(xx, ex / (1.0 - x * y) * strain, 1.0);
}

/// A block under stress in situ, held by the same pressure at its edges, does not move; without
/// the pressure it expands.
#[test]
fn stress_in_situ_is_held_by_the_same_pressure() {
    let in_situ = "/YD/YDIS/IUSEIS 1 /YD/YDIS/DCSTXX 1e6 /YD/YDIS/DCSTYY 1e6\n/YD/YDO/MOHYS 1";
    let stress = ("/YD/YDO/MOHYS 1", in_situ);
    let mut held = square(&with(&[stress, ("D1PNAP 1 0", "D1PNAP 1 1e6")]));
    let start = held.scene().nodes.current.clone();
    run(&mut held, 500);
    for (now, then) in held.scene().nodes.current.iter().zip(&start) {
        assert!((now - then).norm() < 1e-15, "{now} instead of {then}");
    }
    let mut free = square(&with(&[stress]));
    run(&mut free, 500);
    assert!(free.scene().nodes.current[2].norm() > 2f64.sqrt() + 1e-5);
}

/// The joint of the square lies at 45 degrees: its strength is halfway between that along the
/// layers and that across them when layers lie along x and the exponent is 1.
#[test]
fn layers_weaken_joints_along_them() {
    let strength = |angle: f64| {
        let layers = [
            ("D1USAF 1 0", "D1USAF 1 1".to_owned()),
            (
                "/YD/YDPJ/I1PTYP 1 3",
                format!("/YD/YDPJ/I1PTYP 1 3\n/YD/YDPJ/D1PJAL 1 {angle}\n/YD/YDPJ/D1PJTR 1 2e5"),
            ),
        ];
        let edits: Vec<(&str, &str)> = layers.iter().map(|(a, b)| (*a, b.as_str())).collect();
        let simulation = square(&edits);
        let law = &simulation.scene().cohesive_laws[0];
        let layering = law.layering.expect("layers");
        law.along(&layering, Vector2::new(1.0, 1.0)).tensile_strength
    };
    close(strength(45.0), 2e5, 1e-6);
    close(strength(135.0), 1e6, 1e-6);
    close(strength(0.0), 6e5, 1e-6);
    close(strength(90.0), 6e5, 1e-6);
}

/// A fracture along the diagonal: broken from the start (1), cohesive with strengths of its own
/// (2), or broken in the first step (3).
#[test]
fn fracture_networks_open_or_hold() {
    let network = |kind: i32, more: &str| {
        let text = format!(
            "/YD/YDFN/MDFNFR 1 /YD/YDFN/MDFNNO 2 /YD/YDFN/IUSEFN {kind}\n\
             /YD/YDFN/I2DFNN 21 2 1 0 2\n/YD/YDFN/D1DFFR 1 0.1 /YD/YDFN/D1DFPE 1 1e9\n\
             /YD/YDFN/D1DFPT 1 1e8 {more}\n/YD/YDO/MOHYS 1"
        );
        square(&[("/YD/YDO/MOHYS 1", &text)])
    };
    let kind = |simulation: &Simulation| {
        let elements = &simulation.scene().elements;
        let joint = (0..elements.len()).find(|&e| elements.sides[e] == [0, 1]).expect("a joint");
        elements.joint_kind[joint]
    };
    let broken = network(1, "");
    assert_eq!(kind(&broken), JointKind::Broken);
    assert_eq!(joint_views(&broken).filter(|j| j.failure.is_some()).count(), 0);

    let strengths = "/YD/YDFN/DDFNFT 1e5 /YD/YDFN/DDFNCO 1e5 /YD/YDFN/DDFNGF 1 /YD/YDFN/DDFNGS 4";
    let mut cohesive = network(2, strengths);
    run(&mut cohesive, 50);
    assert_eq!(kind(&cohesive), JointKind::Intact);

    let mut of_each = network(3, "/YD/YDFN/I1DFFT 1 1");
    assert_eq!(kind(&of_each), JointKind::Intact);
    step(&mut of_each);
    assert_eq!(kind(&of_each), JointKind::Broken);
    assert_eq!(of_each.failures()[0].mode, 5.0);
}

/// Excavated triangles are out of the way and their joints broken; what was beside them is free.
#[test]
fn excavation_takes_triangles_away() {
    let two_materials = [
        ("I1ELPR 2 0 0", "I1ELPR 2 0 1"),
        ("MPROP 1", "MPROP 2"),
        ("YDPE/NPROP 1", "YDPE/NPROP 2"),
        ("D1PELA 1 1e9", "D1PELA 2 1e9 1e9"),
        ("D1PEMU 1 1e9", "D1PEMU 2 1e9 1e9"),
        ("D1PERO 1 2400", "D1PERO 2 2400 2400"),
        ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 2 1 1"),
        ("I1PEXC 1 0", "I1PEXC 2 0 1"),
        ("MPEROW 1", "MPEROW 3"),
        ("21 5 1 0 0 0.5 1e10 1e9", "21 5 3 0 0 .5 1e10 1e9 0 1 .5 1e10 1e9 1 1 .5 1e10 1e9"),
        ("MPMCOL 3", "MPMCOL 4"),
        ("I2PMSET 21 3 1 1 3 0", "I2PMSET 21 4 1 2 3 0 1"),
        ("MPMROW 1", "MPMROW 3"),
        ("I2PMIJ 21 3 1 0 0 0", "I2PMIJ 21 3 3 0 0 0 1 1 0 0 1 0"),
    ];
    let mut simulation = square(&two_materials);
    run(&mut simulation, 3);
    let scene = simulation.scene();
    for node in scene.elements.corners::<3>(1) {
        let moved = scene.nodes.current[node] - scene.nodes.initial[node];
        assert!((moved - Vector2::new(200.0, 200.0)).norm() < 1e-9);
        assert_eq!(scene.nodes.set[node], 1);
    }
    assert_eq!(simulation.failures().len(), 1);
    assert_eq!(simulation.failures()[0].mode, 4.0);
    // the other triangle falls freely
    let falls = scene.nodes.velocity[scene.elements.corners::<3>(0)[0]];
    close(falls.y, -9.81 * 3e-6, 1e-12);
}

/// Support: what is deformed becomes free of stress, once.
#[test]
fn support_takes_the_present_shape_for_free_of_stress() {
    let stretched = "D2NCC 21 2 4\n0.0 0.0\n1.01 0.0\n1.01 1.0\n0.0 1.0";
    let plain = "D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0";
    let mut supported = square(&with(&[(plain, stretched), ("I1PSUP 1 0", "I1PSUP 1 1")]));
    run(&mut supported, 100);
    assert!(supported.forces().iter().all(|f| f.norm() < 1e-3));
    assert!(!supported.scene().materials[0].resets_shape);
    let mut free = square(&with(&[(plain, stretched)]));
    run(&mut free, 1);
    assert!(free.forces().iter().any(|f| f.norm() > 1e6));
}

/// Half the product of stress and strain, over the whole square of unit area.
#[test]
fn strain_energy_is_recorded() {
    let stretched = "D2NCC 21 2 4\n0.0 0.0\n1.001 0.0\n1.001 1.0\n0.0 1.0";
    let plain = "D2NCC 21 2 4\n0.0 0.0\n1.0 0.0\n1.0 1.0\n0.0 1.0";
    let mut simulation = square(&with(&[
        (plain, stretched),
        ("YDPE/I1PTYP 1 1", "YDPE/I1PTYP 1 5"),
        ("I1OHYT 1 15", "I1OHYT 1 21"),
    ]));
    simulation.evaluate_forces();
    let strain = 0.5 * (1.001f64.powi(2) - 1.0);
    let stress = 2e9 / (1.0 - 0.25 * 0.25) * strain;
    close(simulation.probe_values()[0], 0.5 * stress * strain * 1.001, 1e-6 * stress * strain);
}

/// With hysteresis a joint that closes again gives back less than it took.
#[test]
fn hysteretic_joints_keep_the_energy_of_softening() {
    use ypsilon::mechanics::joint2::{YGeoRules, evaluate};
    let law = square(&[]).scene().cohesive_laws[0].clone();
    let work = |hysteretic: bool| {
        let (mut strength, mut largest) = (2e6, [0.0; 3]);
        let (mut work, mut before) = (0.0, 0.0);
        let opening = |k: i32| if k <= 500 { f64::from(k) } else { f64::from(1000 - k) } * 4e-8;
        for k in 1..=1000 {
            let o = opening(k);
            let corners = [
                Vector2::new(0.0, o),
                Vector2::new(0.1, o),
                Vector2::new(0.1, 0.0),
                Vector2::new(0.0, 0.0),
            ];
            let memory = hysteretic.then_some(&mut largest);
            let response = evaluate::<YGeoRules>(&law, &corners, &mut strength, memory);
            let force: f64 = response.point_forces.iter().map(|f| f.y).sum();
            work += force * (o - before);
            before = o;
        }
        work
    };
    assert!(work(false).abs() < 1e-3, "{}", work(false));
    assert!(work(true) > 0.1, "{}", work(true));
}
