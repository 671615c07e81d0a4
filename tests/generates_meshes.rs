//! Generators: meshes are sound and mirror-symmetric, decks run, tables say what loads say.

use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use ypsilon::meshing::{
    Bond, Drive, Generated, Load, Scenario, Side, Staging, flags,
    kinds::{BlockBond, Bridge, Wall},
    scenario_from_flags,
    spatial::kinds::Wall3d,
};
use ypsilon::{
    scene::{Profile, SpatialContact},
    session::{LoadedDeck, load},
    simulation::{AnySimulation, SolverOptions, face_joint_views},
};

/// Corners of a triangle as bits, from the smallest on.
type Corners = [[u64; 2]; 3];

fn corners(places: [[f64; 2]; 3]) -> Corners {
    // 0 and -0 are one place
    let mut bits = places.map(|p| p.map(|x| (x + 0.0).to_bits()));
    bits.sort_unstable();
    bits
}

fn is_mirror_symmetric(generated: &Generated) -> bool {
    let mesh = &generated.model.mesh;
    let all = |sign: f64| -> BTreeSet<(Corners, usize)> {
        mesh.triangles
            .iter()
            .map(|t| (corners(mesh.corners(t).map(|[x, y]| [sign * x, y])), t.material))
            .collect()
    };
    all(1.0) == all(-1.0)
}

fn bridge(bridge: Bridge) -> Scenario {
    Scenario { bridge: Some(bridge), ..Scenario::default() }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Bridges of all proportions are sound (the generator checks areas, neighbours, cover and
    /// connection) and mirror-symmetric to the bit.
    #[test]
    fn bridges_are_mirror_symmetric(
        diameter in 3.0..13.0f64,
        courses in 9usize..26,
        block in 0.4..0.9f64,
        ring in 0.3..0.7f64,
        stack in any::<bool>(),
        four in any::<bool>(),
        soil in prop_oneof![Just(0.0), 0.5..4.0f64],
    ) {
        let scenario = bridge(Bridge {
            arch_diameter_m: diameter,
            courses,
            block_length_m: block,
            ring_thickness_m: ring,
            bond: if stack { BlockBond::Stack } else { BlockBond::Running },
            triangles_per_block: if four { 4 } else { 2 },
            soil_width_m: soil,
            ..Bridge::default()
        });
        match scenario.generate() {
            Ok(generated) => prop_assert!(is_mirror_symmetric(&generated)),
            // what cannot be meshed says why
            Err(error) => prop_assert!(
                error.to_string().contains("choose") || error.to_string().contains("needs"),
                "{error}"
            ),
        }
    }
}

#[test]
fn the_asymmetric_mesh_differs_in_diagonals_of_the_right_half_only() {
    let of =
        |symmetric| bridge(Bridge { symmetric, ..Bridge::default() }).generate().expect("a bridge");
    let (symmetric, other) = (of(true), of(false));
    assert!(is_mirror_symmetric(&symmetric));
    assert!(!is_mirror_symmetric(&other));
    assert_eq!(symmetric.model.mesh.nodes, other.model.mesh.nodes);
    let left = |generated: &Generated| -> Vec<_> {
        let mesh = &generated.model.mesh;
        let is_left = |t: &&ypsilon::meshing::Triangle| mesh.corners(t).iter().any(|p| p[0] < 0.0);
        mesh.triangles.iter().filter(is_left).copied().collect()
    };
    assert_eq!(left(&symmetric), left(&other));
}

#[test]
fn neighbouring_blocks_have_different_properties() {
    for kind in ["bridge", "wall"] {
        let generated = Scenario::of_kind(kind).expect(kind).generate().expect(kind);
        let (mesh, sets) = (&generated.model.mesh, &generated.properties);
        let mut edges: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for (index, triangle) in mesh.triangles.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (triangle.nodes[k], triangle.nodes[(k + 1) % 3]);
                let Some(other) = edges.insert([a.min(b), a.max(b)], index) else { continue };
                let there = mesh.triangles[other];
                let blocks = |t: usize| {
                    generated.model.substances[mesh.triangles[t].material].bond == Bond::Blocks
                };
                if there.block != triangle.block && blocks(index) && blocks(other) {
                    let [p, q] = [index, other].map(|t| sets.sets[sets.of_triangle[t]].colour);
                    assert_ne!(p, q, "{kind}: blocks {} and {}", triangle.block, there.block);
                }
            }
        }
    }
}

/// A generated deck, read by the program: tables of the deck's text, nodes after joints have been
/// inserted.
fn loaded(generated: &Generated) -> LoadedDeck {
    read(&generated.deck.to_text())
}

/// In space with friction, which is warned of where it does nothing.
fn read(text: &str) -> LoadedDeck {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("generated.y");
    std::fs::write(&path, text).expect("written");
    let spatial_contact = SpatialContact { has_friction: true, ..SpatialContact::default() };
    let options = SolverOptions { spatial_contact, ..SolverOptions::default() };
    load(&path, None, Profile::default(), options).unwrap_or_else(|fault| panic!("{fault:?}"))
}

#[test]
fn masonry_in_space_with_joints_gets_them_inside_bricks_and_between_them() {
    let wall =
        Wall3d { bonded: true, cells: [4, 1, 1], bricks: 3, courses: 4, ..Wall3d::default() };
    let scenario = Scenario { wall_3d: Some(wall), ..Scenario::default() };
    let generated = scenario.generate_in_space().expect("masonry");
    let deck = read(&generated.deck.to_text());
    assert!(deck.findings.is_empty(), "{:?}", deck.findings);
    let simulation = deck.simulation.and_then(AnySimulation::into_spatial).expect("a simulation");
    let mut laws = [0; 2];
    for joint in face_joint_views(&simulation) {
        laws[joint.law] += 1;
    }
    let (model, mut expected) = (&generated.model, [0; 2]);
    for sides in model.mesh.faces().values() {
        if let [a, b] = sides[..] {
            let [a, b] = [a, b].map(|side| model.mesh.tetrahedra[side]);
            let strong = |t: usize| model.substances[t].bond == Bond::Strong;
            let mortar = a.block != b.block && !strong(a.material) && !strong(b.material);
            expected[usize::from(mortar)] += 1;
        }
    }
    assert_eq!(laws, expected, "joints inside and of mortar: {}", model.title);
    assert!(expected[1] > 100);
}

#[test]
fn structures_in_space_and_in_the_plane_are_not_taken_for_each_other() {
    let cube = Scenario::of_kind("cube_3d").expect("a cube");
    assert!(cube.generate().expect_err("in space").to_string().contains("[cube_3d]"));
    let square = Scenario::of_kind("cube").expect("a square");
    assert!(square.generate_in_space().expect_err("in the plane").to_string().contains("[cube]"));
    let loads = vec![Load::Point { force_n: 1.0, x_m: 0.0 }];
    let error = Scenario { loads, ..cube }.generate_in_space().expect_err("loads");
    assert!(error.to_string().contains("in the plane only"), "{error}");
}

/// Sum of the downward forces on all nodes at an instant. Outside of a table the factor is 1.
fn applied(deck: &LoadedDeck, time: f64) -> f64 {
    let database = &deck.database;
    let tables = database.reals("YDPN/D3PNFAC").expect("tables");
    let forces = database.reals("YDPN/D1PNAY").expect("forces");
    let kinds = database.integers("YDPN/I1PNFY").expect("kinds");
    let points = database.integer("YDPN/NPNFACT") as usize;
    let factor = |set: usize| {
        let at = |point: usize| [tables.get3(0, set, point), tables.get3(1, set, point)];
        let mut factor = 1.0;
        for point in 1..points {
            let ([t0, f0], [t1, f1]) = (at(point - 1), at(point));
            if t0 <= time && time <= t1 {
                factor = f0 + (f1 - f0) * (time - t0) / (t1 - t0);
            }
        }
        factor
    };
    let simulation =
        deck.simulation.clone().and_then(AnySimulation::into_plane).expect("a simulation");
    let sets = simulation.scene().nodes.set.iter().map(|&set| set as usize);
    // the deck's own nodes stay behind without a triangle
    let bodies = sets.zip(simulation.masses()).filter(|&(_, mass)| *mass > 0.0);
    bodies
        .map(|(set, _)| set)
        .filter(|&set| kinds.get1(set) == 1)
        .map(|set| -forces.get1(set) * factor(set))
        .sum()
}

#[test]
fn loads_amount_to_what_they_say_in_quarters_every_half_second() {
    let train = Load::Train {
        axles: 4,
        axle_n: 250e3,
        spacing_m: 1.6,
        gap_m: 0.8,
        load_n_per_m: 80e3,
        length_m: 5.1,
    };
    let loads = [
        (Load::Point { force_n: 1e6, x_m: 0.0 }, 1e6),
        (Load::Point { force_n: 1e6, x_m: 0.37 }, 1e6),
        (Load::Distributed { load_n_per_m: 110e3, from_m: None, to_m: None }, 110e3 * 16.6),
        (train, 1e6 + 2.0 * 80e3 * 5.1),
    ];
    for (load, whole) in loads {
        let scenario = Scenario { loads: vec![load], ..bridge(Bridge::default()) };
        let deck = loaded(&scenario.generate().expect("a bridge"));
        for (time, part) in [(1.4, 0.0), (1.7, 0.25), (2.2, 0.5), (2.7, 0.75), (3.4, 1.0)] {
            let (found, expected) = (applied(&deck, time), part * whole);
            assert!((found - expected).abs() < 1e-9 * whole, "{load:?} at {time} s: {found}");
        }
    }
}

#[test]
fn the_ends_of_a_distributed_load_carry_half_as_much() {
    let load = Load::Distributed { load_n_per_m: 110e3, from_m: None, to_m: None };
    let scenario = Scenario { loads: vec![load], ..bridge(Bridge::default()) };
    let generated = scenario.generate().expect("a bridge");
    let (top, copies) = (&generated.model.top, generated.model.copies());
    let force = |node: usize| {
        let motion = &generated.node_sets.sets[generated.node_sets.of_node[node]].motion;
        match motion.drives[1] {
            Drive::Force(force) => -force * copies[node] as f64,
            Drive::Velocity(_) => panic!("the top is free"),
        }
    };
    let n = top.len() as f64;
    assert_eq!(top.len(), 34, "nodes of the top, as in the thesis");
    for (k, &node) in top.iter().enumerate() {
        let at_end = k == 0 || k + 1 == top.len();
        let expected = 110e3 * 16.6 / (n - 1.0) * if at_end { 0.5 } else { 1.0 };
        assert!((force(node) - expected).abs() < 1e-6, "node {k}: {} N", force(node));
    }
}

#[test]
fn a_convoy_weighs_the_same_at_every_instant_of_its_way() {
    let load = Load::Convoy {
        axles: 4,
        axle_n: 250e3,
        spacing_m: 1.6,
        speed_m_s: 100.0 / 3.6,
        interval_s: 0.01,
    };
    let scenario = Scenario { loads: vec![load], ..bridge(Bridge::default()) };
    let deck = loaded(&scenario.generate().expect("a bridge"));
    for k in 0..200 {
        let time = 3.1 + 0.005 * f64::from(k);
        let found = applied(&deck, time);
        assert!((found - 1e6).abs() < 1e-3, "at {time} s: {found} N");
    }
}

#[test]
fn a_settlement_moves_by_velocity_times_duration() {
    let load = Load::Settlement { side: Side::Left, velocity_m_s: 0.2, from_s: 1.5, to_s: 4.5 };
    let scenario = Scenario { loads: vec![load], ..bridge(Bridge::default()) };
    let generated = scenario.generate().expect("a bridge");
    let set = generated.node_sets.sets.iter().find(|set| set.name.contains("settling"));
    let motion = &set.expect("a settling support").motion;
    assert_eq!(motion.drives, [Drive::Velocity(0.0), Drive::Velocity(-0.2)]);
    let way: f64 = motion
        .history
        .windows(2)
        .map(|w| 0.2 * f64::midpoint(w[0][1], w[1][1]) * (w[1][0] - w[0][0]))
        .sum();
    assert!((way - 0.6).abs() < 1e-12, "{way} m");
}

#[test]
fn tables_cover_the_run() {
    for load in [
        Load::Point { force_n: 1e6, x_m: 0.0 },
        Load::HalfSine { load_n_per_m: 110e3, from_s: 1.5, to_s: 3.5 },
    ] {
        let scenario = Scenario { loads: vec![load], ..bridge(Bridge::default()) };
        let generated = scenario.generate().expect("a bridge");
        let instants = &generated.node_sets.instants;
        assert!(instants[0] <= 0.0 && *instants.last().expect("instants") > generated.end_s);
    }
}

#[test]
fn abrupt_loads_are_there_from_the_first_step_on() {
    let scenario = Scenario {
        loads: vec![Load::Point { force_n: 1e6, x_m: 0.0 }],
        staging: Staging::abrupt(),
        ..bridge(Bridge::default())
    };
    let deck = loaded(&scenario.generate().expect("a bridge"));
    assert!((applied(&deck, 0.0) - 1e6).abs() < 1e-3);
}

#[test]
fn every_kind_makes_a_deck_that_can_be_run_and_made_again() {
    for (kind, _) in Scenario::KINDS {
        let generated = Scenario::of_kind(kind).expect(kind).generate_any().expect(kind);
        let text = generated.deck().to_text();
        let deck = read(&text);
        assert!(deck.findings.is_empty(), "{kind}: {:?}", deck.findings);
        let energy = match deck.simulation.expect("a simulation") {
            AnySimulation::Plane(mut simulation) => {
                for _ in 0..20 {
                    simulation.evaluate_forces();
                    simulation.advance();
                }
                simulation.sum_kinetic_energy()
            }
            AnySimulation::Spatial(mut simulation) => {
                for _ in 0..20 {
                    simulation.evaluate_forces();
                    simulation.advance();
                }
                simulation.previous_kinetic_energy()
            }
        };
        assert!(energy.is_finite(), "{kind}");
        // the header holds the scenario
        let lines = text
            .lines()
            .map_while(|line| Some(line.strip_prefix("/*")?.strip_suffix("*/")?.trim().to_owned()));
        let header: Vec<String> = lines.skip(3).take_while(|line| line != "control").collect();
        let again = Scenario::parse(&header.join("\n")).unwrap_or_else(|e| panic!("{kind}: {e}"));
        assert_eq!(again.generate_any().expect(kind).deck().to_text(), text, "{kind}");
    }
}

#[test]
fn the_wall_of_eindhoven_has_eighteen_courses_of_four_and_a_half_bricks() {
    let scenario = Scenario { wall: Some(Wall::default()), ..Scenario::default() };
    let generated = scenario.generate().expect("a wall");
    let mesh = &generated.model.mesh;
    // five bricks and halves of them in each course, nine cells in each beam
    assert_eq!(mesh.blocks, 18 * 5 + 2 * 9);
    assert!((mesh.total_area() - 0.99 * (18.0 * 0.06 + 2.0 * 0.06)).abs() < 1e-12);
    assert_eq!(generated.node_sets.sets.iter().filter(|s| s.name == "lower beam").count(), 1);
}

#[test]
fn flags_are_the_parameters_of_the_scenario() {
    let all = flags("bridge");
    let named = |name: &str| all.iter().find(|flag| flag.name == name).expect("a flag").clone();
    let values = [
        (named("arch-diameter-m"), "4.15".to_owned()),
        (named("stone.young-pa"), "30e9".to_owned()),
        (named("bond"), "stack".to_owned()),
        (named("end-s"), "2".to_owned()),
        (named("staging.part"), "0.5".to_owned()),
    ];
    let loads = ["point force_n=1e6 x_m=0.5".to_owned(), "train".to_owned()];
    let scenario = scenario_from_flags("bridge", None, &values, &loads).expect("a scenario");
    let bridge = scenario.bridge.as_ref().expect("a bridge");
    assert_eq!((bridge.arch_diameter_m, bridge.stone.young_pa), (4.15, 30e9));
    assert_eq!(bridge.bond, BlockBond::Stack);
    assert_eq!((scenario.run.end_s, scenario.staging.part), (Some(2.0), 0.5));
    assert_eq!(scenario.loads[0], Load::Point { force_n: 1e6, x_m: 0.5 });
    assert!(matches!(scenario.loads[1], Load::Train { axles: 4, .. }));
    // over a scenario that is given
    let values = [(named("courses"), "12".to_owned())];
    let changed = scenario_from_flags("bridge", Some(&scenario), &values, &[]).expect("changed");
    let changed = changed.bridge.expect("a bridge");
    assert_eq!((changed.courses, changed.arch_diameter_m), (12, 4.15));
}

#[test]
fn scenarios_with_mistakes_say_where() {
    let messages: Vec<String> = [
        "[bridge]\narch_diameter = 8.3\n",
        "[bridge]\narch_diameter_m = -1\n",
        "[bridge]\nvoussoirs = 10\n",
        "[bridge]\narch_diameter_m = 20\n",
        "[bridge]\nheight_m = 5\n",
        "[bridge]\n[bridge.stone]\npoisson = 0.5\n",
        "[bridge]\n[wall]\n",
        "[run]\nend_s = 1\n",
        "[bridge]\n[run]\nstep_s = 0\n",
        "[bridge]\n[staging]\npart = 2\n",
        "[bridge]\n[staging]\nramp_s = 0\n",
        "[bridge]\n[[loads]]\ntype = \"point\"\nforce_n = 1e6\nx_m = 9\n",
        "[bridge]\n[[loads]]\ntype = \"weight\"\n",
        "[wall]\n[[loads]]\ntype = \"settlement\"\n",
        "[wall]\ncourses = 0\n",
        "[column]\nblocks = 0\n",
        "[column]\nblocks = 2000\ncells = [2000, 2000]\n",
        "[cube_3d]\ncells = [2000, 2000, 2000]\n",
        "[wall_3d]\ncells = [2000, 1, 2000]\n",
        "[column\n",
    ]
    .into_iter()
    .map(|text| {
        let error = Scenario::parse(text).and_then(|scenario| scenario.generate_any());
        format!("{}\n=> {}", text.trim_end(), error.expect_err(text))
    })
    .collect();
    insta::assert_snapshot!(messages.join("\n\n"));
}
