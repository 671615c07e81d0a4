//! Cubes of twelve tetrahedra that run into each other, under every law.

use super::{Contact3, Motion3, Vec3};
use crate::{
    scene::{
        ContactSelection, ContactSettings, Elements, FrictionModel, JointKind, Nodes,
        PairProperties, PairRule, PressedFaces, SpatialContact,
    },
    team::Team,
};

/// Triangles of the surface of a cube whose corner number is x + 2y + 4z, outward normal last.
const SURFACE: [[i32; 3]; 12] = [
    [0, 1, 3],
    [0, 3, 2],
    [4, 7, 5],
    [4, 6, 7],
    [0, 5, 1],
    [0, 4, 5],
    [2, 3, 7],
    [2, 7, 6],
    [0, 2, 6],
    [0, 6, 4],
    [1, 7, 3],
    [1, 5, 7],
];

#[derive(Clone)]
struct Scene {
    nodes: Nodes<3>,
    elements: Elements,
    contact: Contact3,
    mass: f64,
    dt: f64,
}

/// Cubes with these lower corners and velocities.
fn cubes(cubes: &[[[f64; 3]; 2]], spatial: SpatialContact, rests: bool) -> Scene {
    let (mut nodes, mut elements) = (Nodes::<3>::default(), Elements::default());
    for (number, &[corner, velocity]) in cubes.iter().enumerate() {
        let first = nodes.len() as i32;
        let corner_at = |n: u8| Vec3::from([n & 1, n >> 1 & 1, n >> 2 & 1].map(f64::from));
        let all = (0..8).map(corner_at).chain([Vec3::from([0.5; 3])]);
        for place in all {
            nodes.current.push(Vec3::from(corner) + place);
            nodes.velocity.push(Vec3::from(velocity));
            nodes.boundary_flag.push(1);
            nodes.set.push(0);
        }
        for [a, b, c] in SURFACE {
            let corners = [first + a, first + b, first + c, first + 8, -1, -1];
            elements.push(corners, (number % 2) as i32, JointKind::NoJoint);
        }
    }
    nodes.initial = nodes.current.clone();
    let settings = ContactSettings {
        buffer: 0.05,
        initial_travel: 1e15,
        selection: ContactSelection::Tagged,
        pairs: PairRule::SmallerOfEach,
        friction: FrictionModel::Coulomb,
        initial_sliding: vec![],
        spatial,
    };
    let mut contact = Contact3::new(settings, rests);
    let surface = PairProperties { penalty: 1e6, tangential_penalty: 1e6, friction: 0.3 };
    contact.rebuild(&elements, &[Some(surface); 2]);
    Scene { nodes, elements, contact, mass: 100.0, dt: 1e-4 }
}

/// A heap that falls together, skewed so that no faces lie in one plane.
fn heap(spatial: SpatialContact, rests: bool) -> Scene {
    cubes(
        &[
            [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
            [[0.13, 0.21, 1.02], [0.1, 0.2, -1.5]],
            [[1.01, 0.07, 0.4], [-1.0, 0.1, 0.2]],
            [[0.31, 0.11, 2.07], [0.0, -0.3, -2.0]],
        ],
        spatial,
        rests,
    )
}

const LAWS: [SpatialContact; 4] = [
    SpatialContact { pressed: PressedFaces::Contactor, has_friction: false },
    SpatialContact { pressed: PressedFaces::Contactor, has_friction: true },
    SpatialContact { pressed: PressedFaces::Both, has_friction: false },
    SpatialContact { pressed: PressedFaces::Both, has_friction: true },
];

impl Scene {
    fn forces(&mut self) -> Vec<Vec3> {
        let mut forces = vec![Vec3::zeros(); self.nodes.len()];
        let motion = Motion3::from(&self.nodes);
        self.contact.add_forces(motion, &mut self.elements, self.dt, &mut forces);
        forces
    }

    /// One step; cubes stay rigid and do not turn.
    fn step(&mut self) -> Vec<Vec3> {
        let forces = self.forces();
        for cube in 0..self.nodes.len() / 9 {
            let range = 9 * cube..9 * (cube + 1);
            let force: Vec3 = forces[range.clone()].iter().sum();
            for node in range {
                self.nodes.velocity[node] += force * (self.dt / self.mass);
                let velocity = self.nodes.velocity[node];
                self.nodes.current[node] += velocity * self.dt;
            }
        }
        forces
    }

    fn kinetic_energy(&self) -> f64 {
        let cubes = self.nodes.velocity.iter().step_by(9);
        cubes.map(|v| 0.5 * self.mass * v.norm_squared()).sum()
    }
}

fn bits(forces: &[Vec3]) -> Vec<[u64; 3]> {
    // no force and no force backwards are the same
    forces.iter().map(|f| [f.x, f.y, f.z].map(|x| (x + 0.0).to_bits())).collect()
}

#[test]
fn leaving_out_what_does_nothing_changes_no_bit() {
    for law in LAWS {
        let (mut resting, mut thorough) = (heap(law, true), heap(law, false));
        // the two-sided law is the stiffer one: its collisions are short
        (resting.dt, thorough.dt) = (5e-5, 5e-5);
        let mut touched = 0;
        for n in 0..3000 {
            let (some, all) = (resting.step(), thorough.step());
            assert!(bits(&some) == bits(&all), "{law:?}: forces differ in step {n}");
            touched += u32::from(some.iter().any(|f| f.norm() > 1.0));
        }
        assert!(touched > 100, "{law:?}: {touched}");
        assert!(resting.contact.work().rested > 0);
        assert_eq!(thorough.contact.work().rested, 0);
    }
}

#[test]
fn a_state_goes_on_as_if_nothing_had_been() {
    for law in LAWS {
        let mut whole = heap(law, true);
        (0..700).for_each(|_| drop(whole.step()));
        let mut resumed = heap(law, true);
        resumed.nodes = whole.nodes.clone();
        resumed.elements = whole.elements.clone();
        let surface = PairProperties { penalty: 1e6, tangential_penalty: 1e6, friction: 0.3 };
        let restored =
            resumed.contact.restore(whole.contact.state(), &whole.elements, &[Some(surface); 2]);
        assert_eq!(restored, Ok(()));
        for n in 0..300 {
            assert!(bits(&whole.step()) == bits(&resumed.step()), "{law:?}: {n}");
        }
        assert_eq!(whole.contact.work(), resumed.contact.work());
    }
}

#[test]
fn threads_do_not_change_bits() {
    // enough couples to be shared out: a layer of cubes pressed into another
    let corner = |n: usize, z: f64| [0.97 * (n % 4) as f64, 0.98 * (n / 4) as f64, z];
    let layer = |z: f64| (0..16).map(move |n| [corner(n, z), [0.0, 0.0, -z]]);
    let layers: Vec<_> = layer(0.0).chain(layer(0.96)).collect();
    for law in LAWS {
        let on = |threads| {
            let mut scene = cubes(&layers, law, true);
            scene.contact = scene.contact.shared_by(Team::new(threads).expect("threads"));
            (0..3).map(|_| bits(&scene.step())).collect::<Vec<_>>()
        };
        assert!(on(1) == on(3), "{law:?}");
    }
}

#[test]
fn momentum_is_conserved() {
    for law in LAWS {
        let mut scene = heap(law, true);
        for _ in 0..1000 {
            let forces = scene.step();
            let total: Vec3 = forces.iter().sum();
            let size: f64 = forces.iter().map(|f| f.norm()).sum();
            assert!(total.norm() <= 1e-9 * size.max(1.0), "{law:?}: {total}");
        }
    }
}

/// Two cubes meet face to face, a little askew, and part as fast as they came: also where planes of
/// both coincide.
#[test]
fn an_elastic_collision_of_cubes_conserves_energy() {
    let law = SpatialContact { pressed: PressedFaces::Both, has_friction: false };
    for [x, y] in [[0.2, 0.1], [0.2, 0.0], [0.0, 0.0]] {
        let meet = [[[0.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [[x, y, 1.001], [0.0, 0.0, -1.0]]];
        let mut scene = cubes(&meet, law, true);
        scene.dt = 1e-5;
        let before = scene.kinetic_energy();
        let mut least = before;
        for _ in 0..12_000 {
            scene.step();
            least = least.min(scene.kinetic_energy());
        }
        let after = scene.kinetic_energy();
        assert!(least < 0.6 * before, "{x} {y}: {least} of {before}");
        assert!((after - before).abs() < 1e-3 * before, "{x} {y}: {before} {after}");
    }
}

/// Tetrahedra that share a face, an edge or a node and do not overlap let each other alone, rounded
/// as their places may be.
#[test]
fn a_cube_exerts_nothing_on_itself() {
    for law in LAWS.into_iter().filter(|law| law.pressed == PressedFaces::Both) {
        let mut scene = cubes(&[[[0.1, 0.7, 0.3], [0.0; 3]]], law, true);
        let (sine, cosine) = 0.3_f64.sin_cos();
        for (n, x) in scene.nodes.current.iter_mut().enumerate() {
            // turned and bent a little
            *x = Vec3::new(cosine * x.x - sine * x.y, sine * x.x + cosine * x.y, x.z);
            x.z += 0.01 * (n as f64).sin();
        }
        let largest = scene.forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
        assert!(scene.contact.work().evaluated > 0);
        // the penalty is 1e6 Pa
        assert!(largest < 1e-6, "{law:?}: {largest} N");
    }
}

/// A cube thrown along another one is slowed down by friction, and only by it.
#[test]
fn friction_slows_a_sliding_cube() {
    let slide = |has_friction| {
        let law = SpatialContact { pressed: PressedFaces::Both, has_friction };
        let thrown = [[[0.0, 0.0, 0.0], [0.0; 3]], [[0.05, 0.1, 0.995], [0.5, 0.0, 0.0]]];
        let mut scene = cubes(&thrown, law, true);
        scene.nodes.velocity[..9].fill(Vec3::zeros());
        let (mut friction, mut normal) = (0.0, 0.0);
        for _ in 0..1500 {
            let forces = scene.forces();
            let on_upper: Vec3 = forces[9..].iter().sum();
            (friction, normal) = (on_upper.x, on_upper.z);
            for node in 9..18 {
                let velocity = scene.nodes.velocity[node];
                scene.nodes.current[node] += velocity * scene.dt;
            }
        }
        (friction, normal)
    };
    let (without, _) = slide(false);
    let (with, normal) = slide(true);
    // the potential has a pyramid in each tetrahedron: surfaces are smooth to a percent
    assert!(without.abs() < 0.01 * normal, "{without} of {normal}");
    assert!(with < -0.05 * normal && with >= -0.31 * normal, "{with} of {normal}");
}
