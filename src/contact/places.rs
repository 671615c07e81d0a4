//! Lists of couples by their places in a chunk.

use crate::lanes::{LANES, each};

/// All bits of the lanes.
pub(super) const ALL: u32 = (1 << LANES) - 1;

/// Places of couples in a chunk, ascending where nothing else is said. There is always room for more
/// than there can be, so that the list grows without branches.
#[derive(Debug, Clone, Default)]
pub(super) struct Places {
    places: Vec<u32>,
    count: usize,
}

impl Places {
    /// No places, of so many couples at most.
    pub fn with_room_for(couples: usize) -> Self {
        Self { places: vec![0; couples + LANES], count: 0 }
    }

    #[inline(always)]
    pub fn len(&self) -> usize {
        self.count
    }

    #[inline(always)]
    pub fn clear(&mut self) {
        self.count = 0;
    }

    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    #[inline(always)]
    pub fn get(&self) -> &[u32] {
        &self.places[..self.count]
    }

    /// Adds the places `first` + `k` for every bit `k`.
    #[inline(always)]
    pub fn push_lanes(&mut self, first: usize, bits: u32) {
        self.push_those(each!(4, |k| first + k), bits);
    }

    /// Adds the place of every lane that has its bit.
    #[inline(always)]
    pub fn push_those(&mut self, of_lane: [usize; LANES], bits: u32) {
        if bits == 0 {
            return;
        }
        let room: &mut [u32; LANES] = &mut self.places[self.count..].as_chunks_mut().0[0];
        // no branches: which couples are meant cannot be predicted
        let mut count = 0;
        for lane in 0..LANES {
            room[count % LANES] = of_lane[lane] as u32;
            count += (bits >> lane & 1) as usize;
        }
        self.count += count;
    }

    #[cold]
    pub fn sort(&mut self) {
        self.places[..self.count].sort_unstable();
    }

    /// Adds places that are not among these.
    #[cold]
    pub fn insert_sorted(&mut self, others: &Self) {
        let (mut mine, mut theirs) = (self.count, others.count);
        self.count += others.count;
        let mut end = self.count;
        while theirs > 0 {
            end -= 1;
            let other = others.places[theirs - 1];
            if mine > 0 && self.places[mine - 1] > other {
                self.places[end] = self.places[mine - 1];
                mine -= 1;
            } else {
                self.places[end] = other;
                theirs -= 1;
            }
        }
    }
}

/// The first four places, and how many of them there are; a last quartet that is not full repeats
/// its first place.
#[inline(always)]
pub(super) fn quartet(places: &[u32]) -> ([usize; LANES], usize) {
    let count = places.len().min(LANES);
    (each!(4, |k| places[if k < count { k } else { 0 }] as usize), count)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(of: &[usize]) -> Places {
        let mut places = Places::with_room_for(64);
        of.iter().for_each(|&place| places.push_lanes(place, 1));
        places
    }

    #[test]
    fn lanes_are_added_by_their_bits() {
        let mut places = places(&[3]);
        places.push_lanes(8, 0b1010);
        places.push_lanes(12, 0);
        places.push_lanes(16, ALL);
        assert_eq!(places.get(), [3, 9, 11, 16, 17, 18, 19]);
    }

    #[test]
    fn a_last_quartet_repeats_its_first_place() {
        let places = places(&[1, 2, 4, 8, 16, 32]);
        assert_eq!(quartet(places.get()), ([1, 2, 4, 8], 4));
        assert_eq!(quartet(&places.get()[4..]), ([16, 32, 16, 16], 2));
    }

    #[test]
    fn others_are_inserted_in_order() {
        let mut mine = places(&[2, 5, 6, 40]);
        let mut others = places(&[41, 0, 7, 3]);
        others.sort();
        mine.insert_sorted(&others);
        assert_eq!(mine.get(), [0, 2, 3, 5, 6, 7, 40, 41]);
    }
}
