//! The cohesive softening curve (spec `y2d3d.md` D.5), a fit to experiments on
//! concrete.

const A: f64 = 0.63;
const B: f64 = 1.8;
const C: f64 = 6.0;

/// Share of the strength left at damage `damage` in [0, 1]: z(0) = 1 (to
/// rounding), z(1) = 0.
///
/// ∫ z dD over [0, 1] is 0.386307, so that a joint dissipates about
/// 1.159 G_f with the critical opening 3 G_f / f_t.
#[inline]
#[must_use]
pub fn remaining_strength(damage: f64) -> f64 {
    if damage == 0.0 {
        return INTACT;
    }
    soften(damage)
}

/// The curve at zero damage: `exp(0)` and `1⁶` are exactly 1, so that intact
/// joints need neither exponential nor power and keep their bits.
pub(crate) const INTACT: f64 = (1.0 - (A + B - 1.0) / (A + B)) * (A + B);

#[inline]
fn soften(damage: f64) -> f64 {
    (1.0 - ((A + B - 1.0) / (A + B)) * (damage * (A + C * B) / ((A + B) * (1.0 - A - B))).exp())
        * (A * (1.0 - damage) + B * (1.0 - damage).powf(C))
}

#[cfg(test)]
mod tests {
    use super::{INTACT, remaining_strength, soften};

    #[test]
    fn intact_joints_have_the_bits_of_the_curve() {
        assert_eq!(soften(0.0).to_bits(), INTACT.to_bits());
    }

    #[test]
    fn curve_passes_through_the_worked_numbers() {
        for (damage, expected) in [
            (0.0, 1.0),
            (0.25, 0.587_841_704_208_068),
            (0.5, 0.304_138_074_180_373),
            (0.75, 0.150_054_017_458_504),
            (1.0, 0.0),
        ] {
            assert!((remaining_strength(damage) - expected).abs() < 1e-14);
        }
    }

    /// Simpson's rule on the published integral of the curve.
    #[test]
    fn area_under_the_curve_is_the_published_one() {
        let n = 2000;
        let h = 1.0 / f64::from(n);
        let sum: f64 = (0..=n)
            .map(|i| {
                let weight = if i == 0 || i == n {
                    1.0
                } else if i % 2 == 1 {
                    4.0
                } else {
                    2.0
                };
                weight * remaining_strength(f64::from(i) * h)
            })
            .sum();
        assert!((sum * h / 3.0 - 0.386_307).abs() < 1e-6);
    }
}
