//! How far the two sides of a joint have moved apart, as Y-Geo reports it.

/// Keeps the length of an edge from zero where it divides.
const SMALL: f64 = 1e-10;

/// The gap between the sides of a joint, from its corners in single precision.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct JointGap {
    /// Mean tangential displacement of the sides, its magnitude (length).
    pub sliding: f32,
    /// Mean opening, not below zero (length).
    pub opening: f32,
    /// Area between the sides, not below zero.
    pub area: f32,
}

impl JointGap {
    /// From the corners: 0 to 1 is the edge of the first triangle, 2 to 3 that of the second; 0
    /// faces 3 and 1 faces 2 (outputs.md, 5.3).
    ///
    /// A closed joint gives zeros whose signs follow from the direction of the edge; Y-Geo
    /// prints them.
    #[must_use]
    pub fn between(corners: [[f64; 2]; 4]) -> Self {
        let corners = corners.map(|[x, y]| [x as f32, y as f32]);
        let [c0, c1, c2, c3] = corners.map(|corner| corner.map(f64::from));
        let edge = [0, 1].map(|axis| (c1[axis] + c2[axis] - c0[axis] - c3[axis]) / 2.0);
        let length = (edge[0] * edge[0] + edge[1] * edge[1]).sqrt() + SMALL;
        let [ex, ey] = edge.map(|component| component / length);
        let jump = |a: [f64; 2], b: [f64; 2]| {
            let [x, y] = [a[0] - b[0], a[1] - b[1]];
            (y * ey + x * ex, y * ex - x * ey)
        };
        let (sliding_0, opening_0) = jump(c0, c3);
        let (sliding_1, opening_1) = jump(c1, c2);
        let sliding = (sliding_0 + sliding_1) / 2.0;
        Self {
            sliding: if sliding < 0.0 { -sliding } else { sliding } as f32,
            opening: not_negative(((opening_0 + opening_1) / 2.0) as f32),
            area: not_negative(area(corners)),
        }
    }
}

/// Every difference and product in single precision.
fn area([c0, c1, c2, c3]: [[f32; 2]; 4]) -> f32 {
    0.5 * ((c1[0] - c3[0]) * (c0[1] - c2[1]) - (c0[0] - c2[0]) * (c1[1] - c3[1]))
}

/// Zero for negative values; a negative zero stays.
fn not_negative(value: f32) -> f32 {
    if value < 0.0 { 0.0 } else { value }
}
