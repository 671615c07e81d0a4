//! Energy stored in the overlap of two triangles.

use crate::mechanics::Vec2;

/// ∫ (φ_A + φ_B) dA over what two triangles have in common, m²: by the penalty it is the energy
/// whose change their normal forces do. φ is three times the smallest area coordinate, linear in
/// each of the three triangles that the centroid makes with the edges.
pub(in crate::simulation) fn potential(a: &[Vec2; 3], b: &[Vec2; 3]) -> f64 {
    if are_apart(a, b) { 0.0 } else { of_overlapping(a, b) }
}

/// The same of triangles that no edge separates.
pub(super) fn of_overlapping(a: &[Vec2; 3], b: &[Vec2; 3]) -> f64 {
    let mut common = a.to_vec();
    for k in 0..3 {
        common = cut(&common, b[k], b[(k + 1) % 3]);
        if common.len() < 3 {
            return 0.0;
        }
    }
    [a, b].iter().map(|triangle| over(triangle, &common)).sum()
}

/// Whether an edge of either triangle separates them: then they have nothing in common, and exert
/// nothing on each other.
pub(super) fn are_apart(a: &[Vec2; 3], b: &[Vec2; 3]) -> bool {
    let separates = |edges: &[Vec2; 3], corners: &[Vec2; 3]| {
        (0..3).any(|k| {
            let (p, q) = (edges[k], edges[(k + 1) % 3]);
            corners.iter().all(|&c| cross(p, q, c) <= 0.0)
        })
    };
    separates(a, b) || separates(b, a)
}

/// ∫ φ of one triangle over a polygon within it.
fn over(triangle: &[Vec2; 3], polygon: &[Vec2]) -> f64 {
    let centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
    let whole = cross(triangle[0], triangle[1], triangle[2]);
    let parts = (0..3).map(|k| {
        let (p, q) = (triangle[k], triangle[(k + 1) % 3]);
        let mut part = polygon.to_vec();
        for (from, to) in [(p, q), (q, centre), (centre, p)] {
            part = cut(&part, from, to);
        }
        // linear: the sum over a fan of area times the mean of the corners
        let fan = 1..part.len().saturating_sub(1);
        fan.map(|i| {
            let corners = [part[0], part[i], part[i + 1]];
            let heights: f64 = corners.iter().map(|&c| cross(p, q, c) / whole).sum();
            0.5 * cross(corners[0], corners[1], corners[2]) * heights
        })
        .sum::<f64>()
    });
    parts.sum()
}

/// Twice the area of a triangle.
fn cross(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)
}

/// What of a polygon lies on the left of a line.
fn cut(polygon: &[Vec2], from: Vec2, to: Vec2) -> Vec<Vec2> {
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (i, &p) in polygon.iter().enumerate() {
        let q = polygon[(i + 1) % polygon.len()];
        let (d, e) = (cross(from, to, p), cross(from, to, q));
        if d >= 0.0 {
            left.push(p);
        }
        if (d > 0.0 && e < 0.0) || (d < 0.0 && e > 0.0) {
            left.push(p + (q - p) * (d / (d - e)));
        }
    }
    left
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A small triangle within a large one, and the pyramid of a triangle over itself: a third of
    /// its area times the height 1.
    #[test]
    fn potentials_of_known_shapes() {
        let unit = [Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)];
        let twice = potential(&unit, &unit);
        assert!((twice - 2.0 * 0.5 / 3.0).abs() < 1e-15, "{twice}");
        let apart = unit.map(|p| p + Vec2::new(2.0, 0.0));
        assert!(are_apart(&unit, &apart));
        assert_eq!(potential(&unit, &apart), 0.0);
        let beside = [Vec2::new(1.0, 0.0), Vec2::new(1.0, 1.0), Vec2::new(0.0, 1.0)];
        assert!(are_apart(&unit, &beside));
        let into = beside.map(|p| p - Vec2::new(1e-6, 1e-6));
        assert!(!are_apart(&unit, &into));
        // the edges are √2 long and √2 · 1e-6 deep in each other, both heights are 1/√2
        let depth = 2f64.sqrt() * 1e-6;
        let expected = 2.0 * 2f64.sqrt() * 3.0 * depth * depth / 2.0 * 2f64.sqrt();
        assert!((potential(&unit, &into) / expected - 1.0).abs() < 1e-5);
    }
}
