use crate::contact::CoupleList;

/// Slots of couples by the numbers of their elements: in space, contactors have too many couples to
/// look through them for each pair.
#[derive(Debug, Clone, Default)]
pub(super) struct PairIndex {
    /// Key and slot; the place of a key is the first free one from its hash on.
    entries: Vec<(u64, u32)>,
    shift: u32,
}

/// No couple: no element is its own target.
const VACANT: u64 = 0;

impl PairIndex {
    /// Takes the couples that are there now.
    pub fn fill<S: Copy + Default>(&mut self, couples: &CoupleList<S>) {
        // at least half of the places are free
        let places = (2 * couples.len()).next_power_of_two().max(2);
        self.shift = u64::BITS - places.trailing_zeros();
        self.entries.clear();
        self.entries.resize(places, (VACANT, 0));
        for contactor in 0..couples.contactors() as u32 {
            for slot in couples.of(contactor) {
                let key = key(contactor, couples.target(slot));
                let place = self.place(key);
                self.entries[place] = (key, slot);
            }
        }
    }

    /// Slot of a couple.
    #[inline]
    pub fn find(&self, contactor: u32, target: u32) -> Option<u32> {
        let key = key(contactor, target);
        let (found, slot) = self.entries[self.place(key)];
        (found == key).then_some(slot)
    }

    /// Where a key is or belongs.
    #[inline]
    fn place(&self, key: u64) -> usize {
        let mut place = (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> self.shift) as usize;
        loop {
            let (found, _) = self.entries[place];
            if found == key || found == VACANT {
                return place;
            }
            place = (place + 1) & (self.entries.len() - 1);
        }
    }
}

/// Not 0, as the contactor is not element 0.
fn key(contactor: u32, target: u32) -> u64 {
    u64::from(contactor) << 32 | u64::from(target)
}
