//! Limit analysis of a symmetric arch of voussoirs: which thickness holds a line of thrust.

/// Where a line of thrust just fits.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Limit {
    /// The least thickness by the radius of the centre line.
    pub thickness: f64,
    /// Angle of the intrados hinge from the crown \[°\].
    pub intrados_deg: f64,
}

/// The least thickness of a semicircle of equal voussoirs with radial joints, an even number of
/// them, that stands on compression between the joints' ends alone.
pub(super) fn semicircle(voussoirs: usize) -> Limit {
    let (mut falls, mut stands) = (0.01, 0.5);
    for _ in 0..50 {
        let t = f64::midpoint(falls, stands);
        *(if Half::new(voussoirs, t).best().0 >= 0.0 { &mut stands } else { &mut falls }) = t;
    }
    let half = Half::new(voussoirs, stands);
    let (_, thrust) = half.best();
    let lower = half.joints.iter().map(|joint| thrust * joint.inner + joint.inner_moment);
    let most = lower.clone().fold(f64::NEG_INFINITY, f64::max);
    let index = lower.clone().position(|m| m == most).unwrap_or_default();
    Limit { thickness: stands, intrados_deg: 180.0 * index as f64 / voussoirs as f64 }
}

/// A joint of the right half: height of its ends, and moments of the weights between crown and
/// joint about them.
struct Joint {
    inner: f64,
    outer: f64,
    inner_moment: f64,
    outer_moment: f64,
}

/// The right half of an arch of radius 1.
struct Half {
    joints: Vec<Joint>,
}

impl Half {
    fn new(voussoirs: usize, thickness: f64) -> Self {
        let step = std::f64::consts::PI / voussoirs as f64;
        let radii = [1.0 - thickness / 2.0, 1.0 + thickness / 2.0];
        // a voussoir is a trapezium: its middle lies on its axis at this radius
        let [a, b] = radii;
        let middle = (step / 2.0).cos() * 2.0 / 3.0 * (b * b * b - a * a * a) / (b * b - a * a);
        let weight = step.sin() / 2.0 * (b * b - a * a);
        let moment = |x: f64, joint: usize| -> f64 {
            (0..joint).map(|k| weight * (x - middle * ((k as f64 + 0.5) * step).sin())).sum()
        };
        let joint = |k: usize| {
            let (sin, cos) = (k as f64 * step).sin_cos();
            Joint {
                inner: a * cos,
                outer: b * cos,
                inner_moment: moment(a * sin, k),
                outer_moment: moment(b * sin, k),
            }
        };
        Self { joints: (0..=voussoirs / 2).map(joint).collect() }
    }

    /// How much room the moment of the crown's thrust has: negative if no line of thrust fits.
    fn room(&self, thrust: f64) -> f64 {
        let lower = self.joints.iter().map(|j| thrust * j.inner + j.inner_moment);
        let upper = self.joints.iter().map(|j| thrust * j.outer + j.outer_moment);
        upper.fold(f64::INFINITY, f64::min) - lower.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The largest room, and the thrust that has it. The room is concave.
    fn best(&self) -> (f64, f64) {
        let (mut low, mut high) = (0.0, 2.0);
        for _ in 0..100 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if self.room(a) < self.room(b) {
                low = a;
            } else {
                high = b;
            }
        }
        let thrust = f64::midpoint(low, high);
        (self.room(thrust), thrust)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn many_voussoirs_come_to_the_published_limit() {
        let limit = semicircle(2000);
        assert!((limit.thickness - 0.1074).abs() < 2e-4, "{limit:?}");
        assert!((limit.intrados_deg - 54.5).abs() < 0.5, "{limit:?}");
    }
}
