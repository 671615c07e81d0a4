//! The list of couples: which pairs of elements are examined for contact, in
//! which order, and what each keeps from one list to the next.
//!
//! The original keeps couples in slots of a fixed store, chained per contactor
//! with the newest first, and chains free slots likewise. Slots are never
//! cleared, so that a new couple inherits the sliding left in its slot (spec
//! `y2d3d.md` E.3): which slot a couple gets is therefore part of the result
//! and reproduced here. Memory grows with the couples in use, not with the
//! capacity that the deck declares.

use serde::{Deserialize, Serialize};

const NONE: u32 = u32::MAX;

/// A couple in its slot.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Slot<S> {
    target: u32,
    next: u32,
    kept: S,
}

/// Couples chained per contactor (the higher element number of a pair), with
/// what is kept of each: its sliding, above all.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct CoupleList<S> {
    /// Newest couple of each contactor.
    first: Vec<u32>,
    slots: Vec<Slot<S>>,
    /// Freed slots, the one to be used next last.
    free: Vec<u32>,
    /// What is kept in slots that were never used.
    initial: Vec<S>,
}

impl<S: Copy + Default> CoupleList<S> {
    /// An empty list whose slots start with what is given (the default beyond).
    #[must_use]
    pub fn new(initial: Vec<S>) -> Self {
        Self { initial, ..Self::default() }
    }

    /// Makes room for contactors up to `elements`.
    pub fn resize(&mut self, elements: usize) {
        self.first.resize(elements, NONE);
    }

    /// Number of elements that may be contactors.
    #[must_use]
    pub fn contactors(&self) -> usize {
        self.first.len()
    }

    /// Number of couples.
    #[must_use]
    pub fn len(&self) -> usize {
        self.slots.len() - self.free.len()
    }

    /// Number of slots that are or were a couple's.
    #[must_use]
    pub fn slots(&self) -> usize {
        self.slots.len()
    }

    /// Slots of the couples of a contactor, newest first.
    pub fn of(&self, contactor: u32) -> impl Iterator<Item = u32> + Clone {
        let mut slot = self.first[contactor as usize];
        std::iter::from_fn(move || {
            let current = (slot != NONE).then_some(slot)?;
            slot = self.slots[current as usize].next;
            Some(current)
        })
    }

    /// Target element of a couple.
    #[must_use]
    pub fn target(&self, slot: u32) -> u32 {
        self.slots[slot as usize].target
    }

    /// What is kept in a slot.
    #[must_use]
    pub fn kept(&self, slot: u32) -> &S {
        &self.slots[slot as usize].kept
    }

    /// What is kept in a slot, to be updated.
    pub fn kept_mut(&mut self, slot: u32) -> &mut S {
        &mut self.slots[slot as usize].kept
    }

    /// What is kept in all slots, used or free, and what will be in those to come.
    pub fn all_kept(&mut self) -> impl Iterator<Item = &mut S> {
        self.slots.iter_mut().map(|slot| &mut slot.kept).chain(&mut self.initial)
    }

    /// Whether the list is one of so many elements: every slot is in one chain or free.
    ///
    /// # Errors
    /// With what is wrong.
    pub fn check(&self, elements: usize) -> Result<(), &'static str> {
        if self.first.len() != elements {
            return Err("the couples are of another number of elements");
        }
        let mut seen = vec![false; self.slots.len()];
        let mut visit = |slot: u32| -> Result<Slot<S>, &'static str> {
            let entry = self.slots.get(slot as usize).ok_or("a couple has no slot")?;
            if std::mem::replace(&mut seen[slot as usize], true) {
                return Err("a slot belongs to two couples");
            }
            Ok(*entry)
        };
        for &first in &self.first {
            let mut slot = first;
            while slot != NONE {
                let couple = visit(slot)?;
                if couple.target as usize >= elements {
                    return Err("a couple has no target");
                }
                slot = couple.next;
            }
        }
        for &free in &self.free {
            visit(free)?;
        }
        if seen.contains(&false) {
            return Err("a slot is neither free nor a couple's");
        }
        Ok(())
    }

    /// Whether the pair is a couple already.
    #[must_use]
    pub fn find(&self, contactor: u32, target: u32) -> Option<u32> {
        self.of(contactor).find(|&slot| self.target(slot) == target)
    }

    /// Adds a couple at the head of its contactor's chain.
    pub fn insert(&mut self, contactor: u32, target: u32) -> u32 {
        let next = self.first[contactor as usize];
        let slot = if let Some(slot) = self.free.pop() {
            let reused = &mut self.slots[slot as usize];
            (reused.target, reused.next) = (target, next);
            slot
        } else {
            let slot = self.slots.len();
            let kept = self.initial.get(slot).copied().unwrap_or_default();
            self.slots.push(Slot { target, next, kept });
            slot as u32
        };
        self.first[contactor as usize] = slot;
        slot
    }

    /// Removes a couple; its slot is the next to be used again.
    pub fn remove(&mut self, contactor: u32, slot: u32) {
        let next = self.slots[slot as usize].next;
        let head = self.first[contactor as usize];
        if head == slot {
            self.first[contactor as usize] = next;
        } else {
            let mut before = head;
            while before != NONE && self.slots[before as usize].next != slot {
                before = self.slots[before as usize].next;
            }
            debug_assert_ne!(before, NONE, "couple is not in its contactor's chain");
            self.slots[before as usize].next = next;
        }
        self.free.push(slot);
    }
}

#[cfg(test)]
mod tests {
    use super::CoupleList;

    #[test]
    fn newest_couple_comes_first_and_freed_slots_are_reused_with_their_sliding() {
        let mut couples = CoupleList::<f64>::new(vec![]);
        couples.resize(4);
        let a = couples.insert(3, 0);
        let b = couples.insert(3, 1);
        let c = couples.insert(3, 2);
        assert_eq!(couples.of(3).collect::<Vec<_>>(), [c, b, a]);
        *couples.kept_mut(b) = 7.0;
        couples.remove(3, b);
        couples.remove(3, c);
        assert_eq!(couples.of(3).collect::<Vec<_>>(), [a]);
        assert_eq!(couples.insert(2, 0), c);
        let reused = couples.insert(2, 1);
        assert_eq!(reused, b);
        assert_eq!(*couples.kept(reused), 7.0);
        assert_eq!((couples.len(), couples.find(2, 0)), (3, Some(c)));
    }
}
