//! The asymptotic speed of toppling dominoes without friction between them (W. J. Stronge and
//! others; here after J. M. J. van Leeuwen, Am. J. Phys. 78 (2010) 721).
//!
//! Each domino leans on the next one as soon as it has hit it, and all of them turn about their
//! lower front edges: one degree of freedom, the angle of the foremost. A hit is plastic: it makes
//! the next domino turn as fast as the one that hits it.

/// A row of dominoes.
#[derive(Debug, Clone, Copy)]
pub(super) struct Row {
    /// Thickness \[m\].
    pub thickness: f64,
    /// Height \[m\].
    pub height: f64,
    /// Gap \[m\].
    pub gap: f64,
    /// Gravity \[m/s²\].
    pub gravity: f64,
}

/// Inertia and potential energy of a chain, by the mass of a domino.
struct Chain {
    inertia: f64,
    potential: f64,
}

/// Dominoes behind the foremost that count: further ones hardly move.
const LONG: usize = 400;

impl Row {
    /// Angle at which a domino hits the next one \[rad\].
    pub fn hit(&self) -> f64 {
        (self.gap / self.height).asin()
    }

    /// Moment of inertia of a domino about its lower edge, by its mass.
    fn inertia(&self) -> f64 {
        (self.height.powi(2) + self.thickness.powi(2)) / 3.0
    }

    /// All dominoes if the foremost leans by `theta`.
    fn chain(&self, theta: f64) -> Chain {
        let pitch = self.gap + self.thickness;
        let mut chain = Chain { inertia: 0.0, potential: 0.0 };
        let (mut angle, mut rate) = (theta, 1.0_f64);
        for _ in 0..LONG {
            let (sin, cos) = angle.sin_cos();
            chain.inertia += self.inertia() * rate * rate;
            chain.potential += self.gravity * 0.5 * (self.height * cos + self.thickness * sin);
            let lean = ((pitch * cos - self.thickness) / self.height).clamp(-1.0, 1.0).asin();
            rate *= 1.0 - pitch * sin / (self.height * lean.cos());
            angle += lean;
        }
        chain
    }

    /// The speed that the wave comes to \[m/s\].
    pub fn speed(&self) -> f64 {
        let hit = self.hit();
        let end = self.chain(hit);
        // a phase begins with one domino more, upright, and ends with the next hit: the chain has
        // as many dominoes in either
        let mut start = self.chain(0.0);
        start.inertia = self.inertia() + end.inertia;
        let released = start.potential - end.potential;
        // energy in a phase, and plastic hits between phases, repeat themselves
        let last = 2.0 * released * start.inertia / (end.inertia * self.inertia());
        let first = last * (end.inertia / start.inertia).powi(2);
        let energy = 0.5 * start.inertia * first + start.potential;
        let n = 2000;
        let step = hit / f64::from(n);
        let time: f64 = (0..n)
            .map(|k| {
                let chain = self.chain((f64::from(k) + 0.5) * step);
                step / (2.0 * (energy - chain.potential) / chain.inertia).sqrt()
            })
            .sum();
        (self.gap + self.thickness) / time
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_scales_with_the_root_of_gravity_times_height() {
        let row = Row { thickness: 0.0075, height: 0.048, gap: 0.016, gravity: 9.81 };
        let large = Row { thickness: 0.75, height: 4.8, gap: 1.6, gravity: 9.81 };
        assert!((large.speed() / row.speed() - 10.0).abs() < 1e-9);
    }

    #[test]
    fn dominoes_that_lean_on_each_other_touch() {
        let row = Row { thickness: 0.1, height: 1.0, gap: 0.4, gravity: 10.0 };
        // just hit: the one behind leans by the angle of the hit
        let lean = ((0.5 - 0.1) / 1.0_f64).asin();
        assert!((lean - row.hit()).abs() < 1e-15);
        assert!(row.chain(0.0).inertia > row.inertia());
    }
}
