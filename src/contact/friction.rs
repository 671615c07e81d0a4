use crate::scene::Material;

/// Contact properties of a pair of materials: the smaller value of each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairProperties {
    /// Normal penalty, Pa.
    pub penalty: f64,
    /// Tangential penalty, Pa.
    pub tangential_penalty: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
}

impl PairProperties {
    fn of(a: &Material, b: &Material) -> Self {
        Self {
            penalty: a.contact_penalty.min(b.contact_penalty),
            tangential_penalty: a.tangential_penalty.min(b.tangential_penalty),
            friction: a.friction.min(b.friction),
        }
    }

    /// Tangential force for an accumulated `sliding`, limited by Coulomb's law
    /// under the normal force; the sliding is set back to what the limited
    /// force stands for.
    #[inline]
    #[must_use]
    pub fn tangential_force(&self, sliding: &mut f64, normal_force: f64) -> f64 {
        let force = *sliding * self.tangential_penalty;
        if force.abs() > self.friction * normal_force.abs() {
            let limited = force * (self.friction * normal_force / force).abs();
            *sliding = limited / self.tangential_penalty;
            limited
        } else {
            force
        }
    }
}

/// Pair properties of all materials, and the order in which pairs are visited.
#[derive(Debug, Clone, Default)]
pub struct PairTable {
    materials: usize,
    pairs: Vec<Option<PairProperties>>,
}

impl PairTable {
    /// Table of all pairs `(p, q)` with p ≤ q of materials that take part in contact.
    #[must_use]
    pub fn new(materials: &[Material]) -> Self {
        let mut pairs = Vec::with_capacity(materials.len() * materials.len());
        for (p, a) in materials.iter().enumerate() {
            for (q, b) in materials.iter().enumerate() {
                let touch =
                    p <= q && a.kind.takes_part_in_contact() && b.kind.takes_part_in_contact();
                pairs.push(touch.then(|| PairProperties::of(a, b)));
            }
        }
        Self { materials: materials.len(), pairs }
    }

    /// Rank of the pair in the order of visits (p ascending, then q), if the
    /// two materials can touch.
    #[must_use]
    pub fn rank(&self, a: i32, b: i32) -> Option<u32> {
        let (p, q) = (usize::try_from(a.min(b)).ok()?, usize::try_from(a.max(b)).ok()?);
        if q >= self.materials {
            return None;
        }
        let rank = p * self.materials + q;
        self.pairs[rank].is_some().then_some(rank as u32)
    }

    /// Properties of the pair of that rank.
    ///
    /// # Panics
    /// If the rank did not come from [`Self::rank`].
    #[must_use]
    pub fn properties(&self, rank: u32) -> &PairProperties {
        self.pairs[rank as usize].as_ref().expect("rank of a pair that touches")
    }
}

#[cfg(test)]
mod tests {
    use super::PairProperties;

    #[test]
    fn coulomb_limits_the_force_and_the_sliding() {
        let pair = PairProperties { penalty: 1e6, tangential_penalty: 1e5, friction: 0.5 };
        let mut sliding = 1e-3;
        assert_eq!(pair.tangential_force(&mut sliding, 1000.0), 100.0);
        assert_eq!(sliding, 1e-3);
        sliding = -1e-2;
        assert_eq!(pair.tangential_force(&mut sliding, 1000.0), -500.0);
        assert_eq!(sliding, -5e-3);
    }
}
