use crate::scene::{Elements, FractureNetwork, Material, PairProperties, PairRule};

impl PairProperties {
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

impl PairRule {
    /// Properties of the pair of materials `a` ≤ `b`; `before` are those of the
    /// pair visited before.
    fn properties(
        &self,
        numbers: [usize; 2],
        [a, b]: [&Material; 2],
        before: &PairProperties,
    ) -> PairProperties {
        let penalty = a.contact_penalty.min(b.contact_penalty);
        match self {
            Self::SmallerOfEach => PairProperties {
                penalty,
                tangential_penalty: a.tangential_penalty.min(b.tangential_penalty),
                friction: a.friction.min(b.friction),
            },
            Self::InterfaceFriction => PairProperties {
                penalty,
                tangential_penalty: 0.1 * penalty,
                friction: if numbers[0] == numbers[1] {
                    a.friction
                } else {
                    a.interface_friction.min(b.interface_friction)
                },
            },
            Self::Table(rows) => {
                let numbers = numbers.map(|n| n as i64);
                let row = rows.iter().rev().find(|row| row.materials == numbers);
                row.map_or(*before, |row| row.properties)
            }
        }
    }
}

/// Contact that exerts nothing.
const NO_FORCE: PairProperties =
    PairProperties { penalty: 0.0, tangential_penalty: 0.0, friction: 0.0 };

/// Pair properties of all materials, and the order in which pairs are visited.
#[derive(Debug, Clone, Default)]
pub struct PairTable {
    materials: usize,
    /// Pairs of materials, then fractures of the network.
    pairs: Vec<Option<PairProperties>>,
}

impl PairTable {
    /// Table of all pairs `(p, q)` with p ≤ q of materials that take part in contact.
    #[must_use]
    pub fn new(materials: &[Material], rule: &PairRule) -> Self {
        let mut pairs = Vec::with_capacity(materials.len() * materials.len());
        let mut before = PairRule::UNLISTED;
        for (p, a) in materials.iter().enumerate() {
            for (q, b) in materials.iter().enumerate() {
                let touch =
                    p <= q && a.kind.takes_part_in_contact() && b.kind.takes_part_in_contact();
                pairs.push(touch.then(|| {
                    before = rule.properties([p, q], [a, b], &before);
                    // excavated triangles are there, but without force
                    if a.is_excavated || b.is_excavated { NO_FORCE } else { before }
                }));
            }
        }
        Self { materials: materials.len(), pairs }
    }

    /// Table of one material that touches itself.
    #[cfg(test)]
    pub fn of_one(pair: PairProperties) -> Self {
        Self { materials: 1, pairs: vec![Some(pair)] }
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

    /// The largest penalty that a material has against any, Pa; 0 if it touches none.
    #[must_use]
    pub fn largest_penalty(&self, material: i32) -> f64 {
        let ranks = (0..self.materials as i32).filter_map(|other| self.rank(material, other));
        ranks.map(|rank| self.properties(rank).penalty).fold(0.0, f64::max)
    }

    /// Upper bound of all ranks.
    #[must_use]
    pub fn ranks(&self) -> usize {
        self.materials * self.materials
    }

    /// Adds the contact properties of fractures, which count between two
    /// triangles that both lie on one (Y-Geo, spec `contact.md` 3.1).
    #[must_use]
    pub fn with_fractures(mut self, network: Option<&FractureNetwork>) -> Self {
        let fractures = network.iter().flat_map(|n| &n.fractures);
        self.pairs.extend(fractures.map(|f| (f.contact.friction >= 0.0).then_some(f.contact)));
        self
    }

    /// Whether the pair of that rank is of one material.
    #[must_use]
    pub fn is_inside(&self, rank: u32) -> bool {
        let rank = rank as usize;
        rank / self.materials.max(1) == rank % self.materials.max(1)
    }

    /// Index of the properties that two triangles on fractures have: those of
    /// the contactor's fracture.
    #[must_use]
    pub fn along_fracture(&self, elements: &Elements, contactor: u32, target: u32) -> Option<u32> {
        let index = |element: u32| {
            let fracture = usize::try_from(elements.fracture[element as usize]).ok()?;
            let index = self.materials * self.materials + fracture;
            self.pairs.get(index)?.is_some().then_some(index as u32)
        };
        index(target)?;
        index(contactor)
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
    use crate::scene::PairProperties;

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
