use super::{Point, Vec3, cross, dot, vector_product};

/// Local nodes of the faces of a tetrahedron: three counter-clockwise seen from inside, then
/// the opposite node.
pub const FACES: [[usize; 4]; 4] = [[0, 1, 2, 3], [1, 3, 2, 0], [2, 3, 0, 1], [3, 1, 0, 2]];

/// A face of a tetrahedron with its plane's axes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Frame {
    /// Its first node, the origin, m.
    pub origin: Vec3,
    /// Unit vector into the tetrahedron.
    pub normal: Vec3,
    /// Unit vectors of the plane.
    pub axes: [Vec3; 2],
    /// The face's nodes in the plane, m.
    pub corners: [Point; 3],
    /// Twice the face's area, m².
    pub double_area: f64,
}

impl Frame {
    /// Face `face` of a tetrahedron.
    #[inline(always)]
    #[must_use]
    pub fn new(corners: &[Vec3; 4], face: usize) -> Self {
        let [a, b, c, _] = FACES[face];
        let origin = corners[a];
        let (first, second) = (corners[b] - origin, corners[c] - origin);
        let normal = unit(vector_product(&first, &second));
        let along = unit(first);
        let across = vector_product(&normal, &along);
        let place = |r: &Vec3| [dot(r, &along), dot(r, &across)];
        let corners = [[0.0; 2], place(&first), place(&second)];
        let double_area = cross(corners[0], corners[1], corners[2]);
        Self { origin, normal, axes: [along, across], corners, double_area }
    }
}

/// The vector divided by its length.
#[inline(always)]
fn unit(v: Vec3) -> Vec3 {
    let length = dot(&v, &v).sqrt();
    Vec3::new(v.x / length, v.y / length, v.z / length)
}
