use crate::scene::PairProperties;

/// Contact properties of property sets, and the order in which pairs of them are visited.
#[derive(Debug, Clone, Default)]
pub(super) struct Surfaces(Vec<Option<PairProperties>>);

impl Surfaces {
    /// `None` for a property set whose elements take no part in contact.
    pub fn new(properties: &[Option<PairProperties>]) -> Self {
        Self(properties.to_vec())
    }

    fn of(&self, property: i32) -> Option<&PairProperties> {
        self.0.get(usize::try_from(property).ok()?)?.as_ref()
    }

    /// Whether elements of that property set take part.
    pub fn touches(&self, property: i32) -> bool {
        self.of(property).is_some()
    }

    /// Rank of the pair in the order of visits: by the lower set, then by the higher.
    pub fn rank(&self, a: i32, b: i32) -> Option<u32> {
        (self.touches(a) && self.touches(b))
            .then(|| (a.min(b) as usize * self.0.len() + a.max(b) as usize) as u32)
    }

    /// Properties of the pair of that rank: the smaller value of each.
    pub fn pair(&self, rank: u32) -> PairProperties {
        let sets = self.0.len().max(1);
        let rank = rank as usize;
        let of = |set: usize| self.0[set].unwrap_or(NO_FORCE);
        let (a, b) = (of(rank / sets), of(rank % sets));
        PairProperties {
            penalty: a.penalty.min(b.penalty),
            tangential_penalty: a.tangential_penalty.min(b.tangential_penalty),
            friction: a.friction.min(b.friction),
        }
    }
}

/// Contact that exerts nothing.
const NO_FORCE: PairProperties =
    PairProperties { penalty: 0.0, tangential_penalty: 0.0, friction: 0.0 };
