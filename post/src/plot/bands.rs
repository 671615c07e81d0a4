//! Triangles cut along lines of equal value.

/// The part of a triangle where the value, linear between the corners, lies between `low` and
/// `high`; empty if there is none.
pub(super) fn band(corners: [[f64; 2]; 3], values: [f64; 3], low: f64, high: f64) -> Vec<[f64; 2]> {
    let polygon: Vec<([f64; 2], f64)> = corners.into_iter().zip(values).collect();
    let above = cut(&polygon, |v| v - low);
    let between = cut(&above, |v| high - v);
    between.into_iter().map(|(point, _)| point).collect()
}

/// Sutherland and Hodgman: the part of a polygon where `side` is not negative.
fn cut(polygon: &[([f64; 2], f64)], side: impl Fn(f64) -> f64) -> Vec<([f64; 2], f64)> {
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    let Some(mut before) = polygon.last().copied() else { return kept };
    for &here in polygon {
        let (d0, d1) = (side(before.1), side(here.1));
        if (d0 < 0.0) != (d1 < 0.0) {
            let t = d0 / (d0 - d1);
            let mix = |a: f64, b: f64| a + t * (b - a);
            let point = [mix(before.0[0], here.0[0]), mix(before.0[1], here.0[1])];
            kept.push((point, mix(before.1, here.1)));
        }
        if d1 >= 0.0 {
            kept.push(here);
        }
        before = here;
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_fill_the_triangle() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]];
        let values = [0.0, 1.0, 3.0];
        let area = |ring: &[[f64; 2]]| {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(p, q)| p[0] * q[1] - q[0] * p[1]).sum::<f64>() / 2.0
        };
        let areas: Vec<f64> = (0..6)
            .map(|i| area(&band(corners, values, 0.5 * f64::from(i), 0.5 * f64::from(i + 1))))
            .collect();
        assert!((areas.iter().sum::<f64>() - 8.0).abs() < 1e-12, "{areas:?}");
        assert!(areas.iter().all(|a| *a > 0.0));
        assert!(band(corners, values, 5.0, 6.0).is_empty());
        assert_eq!(band(corners, [f64::NAN; 3], 0.0, 1.0).len(), 0);
    }
}
