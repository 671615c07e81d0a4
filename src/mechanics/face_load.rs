//! Pressure on a triangular face (spec `y3d.md` 1.7).

use super::Vec3;

/// Force on each of the three nodes, N; `corners` run counter-clockwise seen from outside,
/// positive pressures (Pa) act into the body. The pressure follows the face.
#[inline]
#[must_use]
pub fn nodal_force(corners: &[Vec3; 3], pressure: f64) -> Vec3 {
    let [a, b, c] = corners;
    (b - a).cross(&(c - a)) * (-pressure / 6.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pressure_acts_inwards_a_third_on_each_node() {
        let force = nodal_force(&[Vec3::zeros(), Vec3::x(), Vec3::y()], 12.0);
        assert_eq!(force, Vec3::new(0.0, 0.0, -2.0));
    }
}
