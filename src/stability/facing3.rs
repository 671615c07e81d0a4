//! Faces of tetrahedra that lie on each other.

use crate::mechanics::Vec3;
use std::collections::HashMap;

/// A face at which a tetrahedron may touch another.
#[derive(Debug, Clone)]
pub struct Face {
    /// The tetrahedron.
    pub element: usize,
    /// Its corners, counter-clockwise seen from outside.
    pub nodes: [usize; 3],
    /// Where these are, m.
    pub places: [Vec3; 3],
    /// Outward.
    pub normal: Vec3,
    /// m²
    pub area: f64,
    /// Of the tetrahedron over it, m.
    pub height: f64,
}

/// A point of integration on two faces: what area it stands for, m², and the area coordinates.
#[derive(Debug, Clone, Copy)]
pub struct CommonPoint {
    /// m²
    pub area: f64,
    /// On both faces.
    pub coordinates: [[f64; 3]; 2],
}

/// How far apart faces may be to count as touching, by the smaller height.
const NEAR: f64 = 1e-6;
/// How far they may overlap, by the smaller height.
const DEEP: f64 = 0.3;
/// Cosine of the angle between faces that count as parallel.
const PARALLEL: f64 = 0.99;

/// The faces that no other tetrahedron shares by its nodes.
pub fn without_shared(faces: Vec<Face>) -> Vec<Face> {
    let key = |face: &Face| {
        let mut nodes = face.nodes;
        nodes.sort_unstable();
        nodes
    };
    let mut count: HashMap<[usize; 3], usize> = HashMap::new();
    faces.iter().for_each(|face| *count.entry(key(face)).or_insert(0) += 1);
    faces.into_iter().filter(|face| count[&key(face)] == 1).collect()
}

/// All pairs of faces that touch.
pub fn pairs(faces: &[Face]) -> Vec<([usize; 2], Vec<CommonPoint>)> {
    let reach = |face: &Face| {
        let slack = DEEP * face.height;
        let x = face.places.map(|p| p.x);
        (x[0].min(x[1]).min(x[2]) - slack, x[0].max(x[1]).max(x[2]) + slack)
    };
    let mut order: Vec<usize> = (0..faces.len()).collect();
    order.sort_by(|&a, &b| reach(&faces[a]).0.total_cmp(&reach(&faces[b]).0));
    let mut open: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for &f in &order {
        let from = reach(&faces[f]).0;
        open.retain(|&o| reach(&faces[o]).1 >= from);
        for &o in &open {
            let numbers = [o.min(f), o.max(f)];
            let points = common(&faces[numbers[0]], &faces[numbers[1]]);
            if !points.is_empty() {
                pairs.push((numbers, points));
            }
        }
        open.push(f);
    }
    pairs
}

/// Points over what two faces have in common; none if they do not touch.
fn common(a: &Face, b: &Face) -> Vec<CommonPoint> {
    if a.element == b.element || a.normal.dot(&b.normal) > -PARALLEL {
        return Vec::new();
    }
    let height = a.height.min(b.height);
    let apart = |coordinates: &[[f64; 3]; 2]| {
        let [on_a, on_b] = [(a, coordinates[0]), (b, coordinates[1])]
            .map(|(face, shares)| (0..3).map(|k| face.places[k] * shares[k]).sum::<Vec3>());
        (on_b - on_a).dot(&a.normal)
    };
    // in the plane of the first; the second runs the other way round
    let e = (a.places[1] - a.places[0]).normalize();
    let g = a.normal.cross(&e);
    let flat = |p: Vec3| [(p - a.places[0]).dot(&e), (p - a.places[0]).dot(&g)];
    let on_a = a.places.map(flat);
    let on_b = b.places.map(flat);
    let mut polygon = vec![on_b[2], on_b[1], on_b[0]];
    for k in 0..3 {
        polygon = cut(&polygon, on_a[k], on_a[(k + 1) % 3]);
    }
    let mut points = Vec::new();
    for k in 1..polygon.len().saturating_sub(1) {
        let fan = [polygon[0], polygon[k], polygon[k + 1]];
        let area = 0.5 * cross(fan[0], fan[1], fan[2]);
        if area <= 1e-9 * a.area.min(b.area) {
            continue;
        }
        let middle = |p: [f64; 2], q: [f64; 2]| [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])];
        let middles = [0, 1, 2].map(|side| middle(fan[side], fan[(side + 1) % 3]));
        let [d, e, f] = middles;
        for part in [[fan[0], d, f], [d, fan[1], e], [f, e, fan[2]], middles] {
            // the middles of the sides integrate quadratic functions exactly
            for side in 0..3 {
                let point = middle(part[side], part[(side + 1) % 3]);
                let coordinates = [on_a, on_b].map(|corners| area_coordinates(&corners, point));
                if (-DEEP * height..=NEAR * height).contains(&apart(&coordinates)) {
                    points.push(CommonPoint { area: area / 12.0, coordinates });
                }
            }
        }
    }
    points
}

/// Twice the area of a triangle.
fn cross(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

fn area_coordinates(corners: &[[f64; 2]; 3], point: [f64; 2]) -> [f64; 3] {
    let [a, b, c] = *corners;
    let whole = cross(a, b, c);
    [cross(point, b, c), cross(a, point, c), cross(a, b, point)].map(|part| part / whole)
}

/// What of a polygon lies on the left of a line.
fn cut(polygon: &[[f64; 2]], from: [f64; 2], to: [f64; 2]) -> Vec<[f64; 2]> {
    let side = |p: [f64; 2]| cross(from, to, p);
    let mut left = Vec::new();
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (d, e) = (side(p), side(q));
        if d >= 0.0 {
            left.push(p);
        }
        if (d > 0.0 && e < 0.0) || (d < 0.0 && e > 0.0) {
            let t = d / (d - e);
            left.push([p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])]);
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(element: usize, z: f64, places: [[f64; 2]; 3], up: f64) -> Face {
        let places = places.map(|[x, y]| Vec3::new(x, y, z));
        let nodes = [3 * element, 3 * element + 1, 3 * element + 2];
        Face { element, nodes, places, normal: Vec3::z() * up, area: 0.5, height: 1.0 }
    }

    #[test]
    fn what_faces_have_in_common_is_their_overlap() {
        let a = face(0, 0.0, [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], 1.0);
        let same = face(1, 0.0, [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]], -1.0);
        let shifted = face(1, 0.0, [[0.5, 0.0], [0.5, 1.0], [1.5, 0.0]], -1.0);
        let above = face(1, 0.1, [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]], -1.0);
        let area = |b: &Face| common(&a, b).iter().map(|p| p.area).sum::<f64>();
        assert!((area(&same) - 0.5).abs() < 1e-14);
        assert!((area(&shifted) - 0.125).abs() < 1e-14);
        assert_eq!(area(&above), 0.0);
    }
}
