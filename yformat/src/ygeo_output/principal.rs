//! Principal stresses and directions with the roundings of Y-Geo.

/// Below this a principal stress counts as zero, and it keeps divisors from zero.
const SMALL: f64 = 1e-10;

/// The principal stresses of a stress tensor of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrincipalStress {
    /// The one of larger magnitude, tension positive (the unit of the stress).
    pub larger: f32,
    /// The other one.
    pub smaller: f32,
    /// Unit vector of `larger`; (1, 0) where the shear stress is below 1 in the unit of the
    /// deck, or 2³¹ and more: Y-Geo tests the shear stress with the absolute value of integers.
    pub larger_direction: [f32; 2],
    /// Unit vector of `smaller`; (0, 1) where `larger_direction` is (1, 0) for that reason.
    pub smaller_direction: [f32; 2],
}

impl PrincipalStress {
    /// From the components of a stress in double precision (outputs.md, 5.1 and 5.2).
    ///
    /// The larger stress is rounded to single precision before the other is divided by it, and
    /// both are rounded before the directions are taken from them; the stress itself is not.
    /// Reference files tell these from other orders.
    #[must_use]
    pub fn of([[xx, xy], [yx, yy]]: [[f64; 2]; 2]) -> Self {
        let (larger, smaller) = stresses(xx, xy, yx, yy);
        let (larger_direction, smaller_direction) =
            if has_whole_magnitude(xy) && has_whole_magnitude(yx) {
                (unit([xy, f64::from(larger) - xx]), unit([f64::from(smaller) - yy, yx]))
            } else {
                ([1.0, 0.0], [0.0, 1.0])
            };
        Self { larger, smaller, larger_direction, smaller_direction }
    }

    /// The lesser of the two by sign: the largest compression.
    #[must_use]
    pub fn minimum(self) -> f32 {
        if self.smaller < self.larger { self.smaller } else { self.larger }
    }

    /// The greater of the two by sign: the largest tension.
    #[must_use]
    pub fn maximum(self) -> f32 {
        if self.smaller < self.larger { self.larger } else { self.smaller }
    }
}

fn stresses(xx: f64, xy: f64, yx: f64, yy: f64) -> (f32, f32) {
    let trace = xx + yy;
    let root = ((xx - yy) * (xx - yy) + 4.0 * xy * yx).sqrt();
    let larger = 0.5 * (trace + trace / (trace.abs() + SMALL) * root);
    if larger.abs() < SMALL {
        return (0.0, 0.0);
    }
    let larger = larger as f32;
    (larger, ((xx * yy - xy * yx) / f64::from(larger)) as f32)
}

/// Whether the absolute value of C's integers, of the value cut to an integer, is 1 or more.
fn has_whole_magnitude(value: f64) -> bool {
    const TOO_LARGE: f64 = 2_147_483_648.0;
    (1.0..TOO_LARGE).contains(&value.abs())
}

fn unit([x, y]: [f64; 2]) -> [f32; 2] {
    let length = (x * x + y * y).sqrt();
    [(x / length) as f32, (y / length) as f32]
}
