//! Results do not depend on where the origin is, on directions, units and numbers.

use super::motion::Vec3;
use crate::support::stability_scenes::{Body, Moving};
use nalgebra::{Matrix3, Rotation3};
use ypsilon::scene::{PressedFaces, SpatialContact};

/// A scene and its velocities at the start.
struct Case {
    name: &'static str,
    body: Body,
    /// Share of the critical step.
    share: f64,
    steps: usize,
}

/// Places and velocities of the corners of all bodies' elements, in the order of the deck: joints
/// give nodes other numbers.
fn corners(moving: &Moving) -> Vec<[Vec3; 2]> {
    let mut found = Vec::new();
    match moving {
        Moving::Plane(simulation) => {
            let scene = simulation.scene();
            for e in simulation.triangles() {
                for n in scene.elements.corners::<3>(e) {
                    let (x, v) = (scene.nodes.current[n], scene.nodes.velocity[n]);
                    found.push([Vec3::new(x.x, x.y, 0.0), Vec3::new(v.x, v.y, 0.0)]);
                }
            }
        }
        Moving::Space(simulation) => {
            let scene = simulation.scene();
            for e in simulation.tetrahedra() {
                for n in scene.elements.corners::<4>(e) {
                    found.push([scene.nodes.current[n], scene.nodes.velocity[n]]);
                }
            }
        }
    }
    found
}

/// Velocities that bend, stretch and turn a body, and drive the parts above `height` downwards.
fn push(mut body: Body, speed: f64, height: f64) -> Body {
    let d = body.dimension;
    body.velocities = body
        .coordinates
        .chunks(d)
        .flat_map(|x| {
            let (along, up) = (x[0], x[d - 1]);
            let mut v = vec![0.0; d];
            v[0] = speed * (0.3 * up - 0.2 * along + 0.1 * along * up);
            v[d - 1] = speed * (0.25 * along - 0.15 * up * up)
                + if up > height { -10.0 * speed } else { 0.0 };
            if d == 3 {
                v[1] = speed * (0.2 * x[1] - 0.3 * along * up);
            }
            v
        })
        .collect();
    body
}

fn cases() -> Vec<Case> {
    let both = SpatialContact { pressed: PressedFaces::Both, has_friction: true };
    let joints = Some([1e5, 1e3]);
    let (high, speed) = (f64::INFINITY, 1e-3);
    let rubbing = |dimension: usize| Body {
        penalty: 1e5,
        friction: 0.3,
        viscosity: 100.0,
        spatial_contact: both,
        ..Body::new(dimension)
    };
    let mut blocks = rubbing(2);
    blocks.add_rectangle([0.0, 0.0], [3, 2], 1.0, 0.1);
    blocks.add_rectangle([0.37, 2.001], [2, 2], 1.0, 0.15);
    let mut cubes = rubbing(3);
    cubes.add_block([0.0; 3], [1, 1, 1], 1.0);
    cubes.add_block([0.3, 0.2, 1.001], [1, 1, 1], 1.0);
    let cracking = Body {
        joints: Some([1e5, 2.0]),
        fracture_energy: Some(1e-3),
        ..Body::rectangle([3, 3], 1.0, 0.2)
    };
    let mut list = vec![
        ("plate", push(Body::rectangle([4, 4], 1.0, 0.3), speed, high), 2000),
        (
            "plate on joints",
            push(Body { joints, ..Body::rectangle([3, 3], 1.0, 0.2) }, speed, high),
            2000,
        ),
        ("plate that cracks", push(cracking, speed, high), 1000),
        ("blocks that collide and rub", push(blocks, speed, 1.999), 1000),
        ("tetrahedra", push(Body::block([1, 2, 1], 1.0), speed, high), 2000),
        (
            "tetrahedra on joints",
            push(Body { joints, ..Body::block([1, 1, 1], 1.0) }, speed, high),
            1000,
        ),
        ("cubes that collide and rub", push(cubes, speed, 0.9999), 1000),
    ];
    list.drain(..).map(|(name, body, steps)| Case { name, body, share: 0.2, steps }).collect()
}

impl Case {
    /// The same scene otherwise: places, velocities and everything else as `change` makes them, with
    /// a unit of time.
    fn run(&self, change: impl FnOnce(&mut Body), second: f64) -> (Vec<[Vec3; 2]>, Vec<[Vec3; 2]>) {
        let dt = {
            let limits = self.body.simulation().limits();
            // a power of two: a change of units keeps its bits
            let longest = self.share * limits.critical_s.min(limits.impact_s);
            2f64.powf(longest.log2().floor())
        };
        let mut body = self.body.clone();
        change(&mut body);
        let mut moving = body.simulation();
        let start = corners(&moving);
        moving.run(dt * second, self.steps);
        (start, corners(&moving))
    }
}

/// Rounding as it grows over the steps of a scene, in places and in velocities.
const ROUNDING: [f64; 2] = [1e-10, 1e-8];

fn assert_within(found: [f64; 2], most: [f64; 2], what: &str) {
    assert!(found[0] <= most[0] && found[1] <= most[1], "{what}: {found:?}, expected {most:?}");
}

/// Largest differences of places, by the longest way, and of velocities, by the largest.
fn difference(
    (start, end): &(Vec<[Vec3; 2]>, Vec<[Vec3; 2]>),
    other: &[[Vec3; 2]],
    back: impl Fn(Vec3, bool) -> Vec3,
) -> [f64; 2] {
    assert_eq!(end.len(), other.len());
    let way = start.iter().zip(end).map(|(s, e)| (e[0] - s[0]).norm()).fold(0.0, f64::max);
    let speed = end.iter().map(|e| e[1].norm()).fold(0.0, f64::max);
    let mut worst: [f64; 2] = [0.0; 2];
    for (e, o) in end.iter().zip(other) {
        worst[0] = worst[0].max((back(o[0], true) - e[0]).norm() / way);
        worst[1] = worst[1].max((back(o[1], false) - e[1]).norm() / speed);
    }
    worst
}

/// Changes all vectors of a body: places as a whole, velocities without the translation.
fn map(body: &mut Body, linear: &Matrix3<f64>, shift: Vec3) {
    let d = body.dimension;
    for (values, shift) in [(&mut body.coordinates, shift), (&mut body.velocities, Vec3::zeros())] {
        for x in values.chunks_mut(d) {
            let full = Vec3::new(x[0], x[1], if d == 3 { x[2] } else { 0.0 });
            let mapped = linear * full + shift;
            x.copy_from_slice(&mapped.as_slice()[..d]);
        }
    }
}

/// Which way round elements have to be listed after a mirror.
fn reverse(body: &mut Body) {
    for element in body.elements.chunks_mut(body.dimension + 1) {
        element.swap(1, 2);
    }
}

#[test]
fn wherever_the_origin_is() {
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        for shift in [1.0, 100.0, 1e4, 1e6] {
            let by = Vec3::new(
                shift,
                -0.7 * shift,
                if case.body.dimension == 3 { 0.3 * shift } else { 0.0 },
            );
            let moved = case.run(|body| map(body, &Matrix3::identity(), by), 1.0);
            let found =
                difference(&plain, &moved.1, |x, is_place| if is_place { x - by } else { x });
            // places are known to a part in 10¹⁶ of their distance from the origin
            let most = ROUNDING.map(|e| e * (1.0 + shift));
            assert_within(found, most, &format!("{} {shift} m away", case.name));
        }
    }
}

#[test]
fn whichever_way_the_axes_point() {
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        let quarter = Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        let mut turns = vec![("quarter turn", quarter)];
        let any = match case.body.dimension {
            2 => Rotation3::from_axis_angle(&Vec3::z_axis(), 0.7),
            _ => Rotation3::from_euler_angles(0.7, -0.4, 1.9),
        };
        turns.push(("any turn", any.into_inner()));
        if case.body.dimension == 3 {
            turns.push(("axes in turn", Matrix3::new(0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)));
        }
        for (name, turn) in turns {
            let turned = case.run(|body| map(body, &turn, Vec3::zeros()), 1.0);
            let found = difference(&plain, &turned.1, |x, _| turn.transpose() * x);
            assert_within(found, ROUNDING, &format!("{}, {name}", case.name));
            // a quarter turn in the plane changes no sum of two
            if name == "quarter turn" && case.body.dimension == 2 {
                assert_within(found, [0.0, 1e-15], case.name);
            }
        }
    }
}

#[test]
fn in_the_mirror() {
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        let mirror = Matrix3::from_diagonal(&Vec3::new(-1.0, 1.0, 1.0));
        let mut mirrored = case.run(
            |body| {
                map(body, &mirror, Vec3::zeros());
                reverse(body);
            },
            1.0,
        );
        let corners = case.body.dimension + 1;
        mirrored.1.chunks_mut(corners).for_each(|element| element.swap(1, 2));
        let found = difference(&plain, &mirrored.1, |x, _| mirror * x);
        assert_within(found, ROUNDING, case.name);
    }
}

/// Everything in a body in other units: so many of the new ones are a metre, a second, a kilogram.
fn rescale(body: &mut Body, metre: f64, second: f64, kilogram: f64) {
    let (length, speed) = (metre, metre / second);
    body.coordinates.iter_mut().for_each(|x| *x *= length);
    body.velocities.iter_mut().for_each(|v| *v *= speed);
    let pressure = kilogram / (metre * second * second);
    body.young *= pressure;
    body.penalty *= pressure;
    body.tangential = match body.dimension {
        // the spring of an edge is D1PEPT times the square of the edge
        2 => Some(0.1 * body.penalty / (metre * metre)),
        _ => Some(0.1 * body.penalty),
    };
    body.viscosity *= pressure * second;
    body.density *= kilogram / (metre * metre * metre);
    body.buffer *= length;
    let energy = pressure * metre;
    body.fracture_energy = Some(
        body.fracture_energy.unwrap_or(body.joints.map_or(0.0, |[_, strength]| strength)) * energy,
    );
    body.joints = body.joints.map(|values| values.map(|p| p * pressure));
}

/// Powers of two change no bits, but for joints: there the method adds 1e-10 m to lengths, and in
/// space gives a sliding below it no direction.
#[test]
fn in_whatever_units() {
    let power = |n: i32| 2f64.powi(n);
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        let has_joints = case.body.joints.is_some();
        for (name, [metre, second, kilogram]) in [
            ("a million times as dense", [1.0, 1.0, power(20)]),
            ("a millionth as dense", [1.0, 1.0, power(-20)]),
            ("other units", [power(10), power(-10), power(6)]),
            ("small", [power(-6), power(-6), power(-3)]),
            ("a million times as large", [power(20), power(20), power(60)]),
            ("a millionth as large", [power(-20), power(-20), power(-60)]),
            ("mm, ms, t", [1e3, 1e3, 1e-3]),
            ("km, h, g", [1e-3, 1.0 / 3600.0, 1e3]),
        ] {
            let other = case.run(|body| rescale(body, metre, second, kilogram), second);
            let what = format!("{} in {name}", case.name);
            if name == "a millionth as large" && case.body.dimension == 3 {
                // nodes lighter than 1e-10 kg never move
                let places =
                    |corners: &[[Vec3; 2]]| corners.iter().map(|c| c[0]).collect::<Vec<_>>();
                assert_eq!(places(&other.0), places(&other.1), "{what}");
                continue;
            }
            let found = difference(&plain, &other.1, |x, is_place| {
                if is_place { x / metre } else { x / (metre / second) }
            });
            let tolerance = match (has_joints, case.body.dimension) {
                (false, _) => [0.0; 2],
                (true, 2) => [1e-9, 1e-7],
                (true, _) => [1e-7, 1e-5],
            };
            let is_power = !name.contains(',');
            let rounding = if is_power { [0.0; 2] } else { ROUNDING };
            let most = [0, 1].map(|k| rounding[k] + tolerance[k] / metre.min(1.0));
            assert_within(found, most, &what);
        }
    }
}

/// Numbers in an order that mixes all of them.
fn shuffled(count: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    for last in (1..count).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        order.swap(last, (state % (last as u64 + 1)) as usize);
    }
    order
}

#[test]
fn however_nodes_are_numbered() {
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        let renumbered = case.run(
            |body| {
                let (d, order) = (body.dimension, shuffled(body.sets.len()));
                let old = body.clone();
                for (from, &to) in order.iter().enumerate() {
                    for k in 0..d {
                        body.coordinates[to * d + k] = old.coordinates[from * d + k];
                        body.velocities[to * d + k] = old.velocities[from * d + k];
                    }
                    body.sets[to] = old.sets[from];
                }
                body.elements.iter_mut().for_each(|n| *n = order[*n as usize] as i64);
            },
            1.0,
        );
        let found = difference(&plain, &renumbered.1, |x, _| x);
        assert_eq!(found, [0.0; 2], "{}", case.name);
    }
}

#[test]
fn however_elements_are_numbered() {
    for case in cases() {
        let plain = case.run(|_| (), 1.0);
        let corners = case.body.dimension + 1;
        let order = shuffled(case.body.elements.len() / corners);
        let mut renumbered = case.run(
            |body| {
                let old = body.elements.clone();
                for (from, &to) in order.iter().enumerate() {
                    let row = &old[from * corners..(from + 1) * corners];
                    body.elements[to * corners..(to + 1) * corners].copy_from_slice(row);
                }
            },
            1.0,
        );
        let other = renumbered.1.clone();
        for (from, &to) in order.iter().enumerate() {
            let row = &other[to * corners..(to + 1) * corners];
            renumbered.1[from * corners..(from + 1) * corners].copy_from_slice(row);
        }
        let found = difference(&plain, &renumbered.1, |x, _| x);
        assert_within(found, ROUNDING, case.name);
    }
}
