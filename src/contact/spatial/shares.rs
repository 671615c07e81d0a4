use super::{FACES, Frame, Point, Vec3, cross, pressure::Resultant, section::View};
use crate::lanes::each;

/// Below this share of the sub-tetrahedron's volume (six times it) the target's face is seen too
/// much from the side; an area is held against a volume, as in the original.
const OBLIQUE: f64 = 0.1;

/// What each node of the contactor bears: the force's area coordinates in the face.
#[inline(always)]
pub(super) fn of_contactor(frame: &Frame, face: usize, resultant: &Resultant) -> [f64; 4] {
    let corners = &frame.corners;
    let mut shares = [0.0; 4];
    for i in 0..3 {
        let (from, to, opposite) = (i, (i + 1) % 3, (i + 2) % 3);
        let area = cross(corners[from], corners[to], resultant.centre);
        shares[FACES[face][opposite]] = resultant.force * (area / frame.double_area);
    }
    shares
}

/// What each node of the target bears: the area coordinates in its face as projected on the plane
/// or, where that is seen from the side, in the triangle of two of its nodes and the centroid.
#[inline(always)]
pub(super) fn of_target(view: &View, face: usize, volume: f64, resultant: &Resultant) -> [f64; 4] {
    let nodes = FACES[face];
    let corners = each!(3, |i| view.place(nodes[i]));
    let double_area = cross(corners[0], corners[1], corners[2]);
    let mut shares = [0.0; 4];
    if double_area.abs() >= OBLIQUE * volume {
        for i in 0..3 {
            let area = cross(corners[i], corners[(i + 1) % 3], resultant.centre);
            shares[nodes[(i + 2) % 3]] = resultant.force * (area / double_area);
        }
        return shares;
    }
    let left_out = replaced(&corners, each!(3, |i| view.points[nodes[i]]));
    let (next, last) = ((left_out + 1) % 3, (left_out + 2) % 3);
    let centroid = view.place(4);
    let triangle = [corners[next], corners[last], centroid];
    let double_area = cross(triangle[0], triangle[1], triangle[2]);
    let share = |from: usize, to: usize| {
        let area = cross(triangle[from], triangle[to], resultant.centre);
        resultant.force * (area / double_area)
    };
    shares[nodes[next]] = share(1, 2);
    shares[nodes[last]] = share(2, 0);
    let quarter = 0.25 * share(0, 1);
    for node in &nodes[..3] {
        shares[*node] += quarter;
    }
    shares[nodes[3]] = quarter;
    shares
}

/// The node of a face seen from the side that the centroid stands in for: an end of the shortest
/// edge.
fn replaced(corners: &[Point; 3], points: [Vec3; 3]) -> usize {
    let length = |i: usize| {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        (b[0] - a[0]).abs() + (b[1] - a[1]).abs()
    };
    let mut shortest = 0;
    for i in 1..3 {
        if length(i) < length(shortest) {
            shortest = i;
        }
    }
    let next = (shortest + 1) % 3;
    if points[next].z.abs() > points[shortest].z.abs() { next } else { shortest }
}
