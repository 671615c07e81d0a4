//! The original's law as spec `y2d3d.md` E.4 states it, number by number: what the kernel is held
//! against.

use super::{FACES, FaceForce, Frame, Point, Tetrahedron, Vec3, cross, dot, vector_product};
use crate::TOLERANCE;

fn lerp(a: Point, b: Point, weight: f64) -> Point {
    [(1.0 - weight) * a[0] + weight * b[0], (1.0 - weight) * a[1] + weight * b[1]]
}

fn changes_sign(a: f64, b: f64) -> bool {
    a > TOLERANCE && b < -TOLERANCE || a < -TOLERANCE && b > TOLERANCE
}

/// Forces of all pairs of faces.
pub fn overlap(target: &Tetrahedron, contactor: &[Vec3; 4], penalty: f64) -> Vec<FaceForce> {
    let mut forces = Vec::new();
    for target_face in FACES {
        for face in 0..4 {
            forces.extend(faces(target, target_face, contactor, face, penalty));
        }
    }
    forces
}

fn faces(
    target: &Tetrahedron,
    nodes: [usize; 4],
    contactor: &[Vec3; 4],
    face: usize,
    penalty: f64,
) -> Option<FaceForce> {
    let frame = Frame::new(contactor, face);
    let corner = |i: usize| if i == 3 { target.centroid } else { target.corners[nodes[i]] };
    let t: Vec<Vec3> = (0..4).map(|i| corner(i) - frame.origin).collect();
    let d: Vec<f64> = t.iter().map(|t| dot(&frame.normal, t)).collect();
    let uv: Vec<Point> = t.iter().map(|t| frame.axes.map(|axis| dot(t, &axis))).collect();
    if d[..3].iter().all(|&d| d <= TOLERANCE) {
        return None;
    }
    let mut s = Vec::new();
    for i in 0..3 {
        for o in [3, (i + 1) % 3] {
            if changes_sign(d[i], d[o]) {
                let w = (d[i] / (d[i] - d[o]).abs()).abs();
                s.push([0, 1].map(|k| w * uv[o][k] + (1.0 - w) * uv[i][k]));
            }
        }
    }
    if s.len() < 3 {
        return None;
    }
    if cross(s[0], s[1], s[2]) < 0.0 {
        s.reverse();
    }
    let polygon = common(&s, &frame.corners)?;
    let normal = vector_product(&(t[1] - t[0]), &(t[2] - t[0]));
    let height = dot(&(t[3] - t[0]), &normal);
    let at_origin = dot(&-t[0], &normal) / height;
    let slopes = frame.axes.map(|axis| dot(&axis, &normal) / height);
    let potential = |p: Point| at_origin + p[0] * slopes[0] + p[1] * slopes[1];
    let (mut f, mut centre) = (0.0f64, [0.0; 2]);
    for i in 1..polygon.len() - 1 {
        let corners = [polygon[0], polygon[i], polygon[i + 1]];
        let p = corners.map(potential);
        let sum = p[0] + p[1] + p[2];
        if sum <= TOLERANCE {
            continue;
        }
        let df = cross(corners[0], corners[1], corners[2]) * sum * penalty;
        let w0 = (0.5 * p[0] + 0.25 * (p[1] + p[2])) / sum;
        let w1 = (0.5 * p[1] + 0.25 * (p[0] + p[2])) / sum;
        let w2 = 1.0 - w0 - w1;
        if (df + f).abs() > TOLERANCE {
            centre = [0, 1].map(|k| {
                let place = w0 * corners[0][k] + w1 * corners[1][k] + w2 * corners[2][k];
                (f * centre[k] + df * place) / (f + df)
            });
            f += df;
        }
    }
    if f == 0.0 {
        return None;
    }
    let area = |a: Point, b: Point| cross(a, b, centre);
    let mut of_contactor = [0.0; 4];
    for i in 0..3 {
        let (q, r) = (frame.corners[i], frame.corners[(i + 1) % 3]);
        of_contactor[FACES[face][(i + 2) % 3]] = f * (area(q, r) / frame.double_area);
    }
    let mut of_target = [0.0; 4];
    let double_area = cross(uv[0], uv[1], uv[2]);
    if double_area.abs() < 0.1 * height {
        let length = |i: usize| {
            let (a, b) = (uv[i], uv[(i + 1) % 3]);
            (b[0] - a[0]).abs() + (b[1] - a[1]).abs()
        };
        let mut r = (0..3).fold(0, |r, i| if length(i) < length(r) { i } else { r });
        if t[(r + 1) % 3].z.abs() > t[r].z.abs() {
            r = (r + 1) % 3;
        }
        let (a, b) = ((r + 1) % 3, (r + 2) % 3);
        let double_area = cross(uv[a], uv[b], uv[3]);
        of_target[nodes[a]] = f * (area(uv[b], uv[3]) / double_area);
        of_target[nodes[b]] = f * (area(uv[3], uv[a]) / double_area);
        let quarter = 0.25 * (f * (area(uv[a], uv[b]) / double_area));
        (0..3).for_each(|i| of_target[nodes[i]] += quarter);
        of_target[nodes[3]] = quarter;
    } else {
        for i in 0..3 {
            let share = area(uv[i], uv[(i + 1) % 3]) / double_area;
            of_target[nodes[(i + 2) % 3]] = f * share;
        }
    }
    Some(FaceForce { normal: frame.normal, target: of_target, contactor: of_contactor })
}

fn common(s: &[Point], q: &[Point; 3]) -> Option<Vec<Point>> {
    let n = s.len();
    let dcs = |j: usize, i: usize| cross(q[j], q[(j + 1) % 3], s[i % n]);
    let dsc = |i: usize, j: usize| cross(s[i], s[(i + 1) % n], q[j % 3]);
    let s_inside = |i: &usize| (0..3).all(|j| dcs(j, *i) >= 0.0);
    let q_inside = |j: &usize| (0..n).all(|i| dsc(i, *j) >= 0.0);
    if (0..3).all(|j| q_inside(&j)) {
        return Some(q.to_vec());
    }
    if (0..n).all(|i| s_inside(&i)) {
        return Some(s.to_vec());
    }
    let mut b: Vec<Point> = (0..n).filter(s_inside).map(|i| s[i]).collect();
    b.extend((0..3).filter(q_inside).map(|j| q[j]));
    for i in 0..n {
        for j in 0..3 {
            if changes_sign(dsc(i, j), dsc(i, j + 1)) && changes_sign(dcs(j, i), dcs(j, i + 1)) {
                let difference = (dsc(i, j) - dsc(i, j + 1)).abs();
                let w = if difference < TOLERANCE { 0.5 } else { (dsc(i, j) / difference).abs() };
                b.push(lerp(q[j], q[(j + 1) % 3], w));
            }
        }
    }
    if b.len() < 3 {
        return None;
    }
    for i in 1..b.len() {
        if b[i][1] < b[0][1] {
            b.swap(0, i);
        }
    }
    let away = |x: f64| match x {
        _ if x.abs() >= TOLERANCE => x,
        _ if x < 0.0 => x - TOLERANCE,
        _ => x + TOLERANCE,
    };
    let mut slopes: Vec<f64> =
        b.iter().map(|p| (p[1] - b[0][1] + TOLERANCE) / away(p[0] - b[0][0])).collect();
    for i in 1..b.len() {
        for j in i + 1..b.len() {
            let (x, y) = (slopes[i], slopes[j]);
            if (x >= 0.0 && y >= 0.0 && y < x) || (x < 0.0 && (y >= 0.0 || y < x)) {
                b.swap(i, j);
                slopes.swap(i, j);
            }
        }
    }
    Some(b)
}
