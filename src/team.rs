//! Threads that share the work of every step.
//!
//! A step of a few thousand triangles takes 0.05 to 1 ms and has several regions that threads can
//! share. Threads that go to sleep between them, as those of general pools do, need longer to wake
//! up than their share of the work takes (measured, `docs/src/performance.md`). Those of a [`Team`]
//! stay awake for a while after each region and only then go to sleep.

mod crew;

use crew::Crew;
use std::{
    fmt, io,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicU64, Ordering},
    },
};

/// Some threads, the calling one among them. Clones are the same threads.
#[derive(Clone, Default)]
pub struct Team {
    /// The others, if there are any.
    crew: Option<Arc<Crew>>,
}

impl Team {
    /// Most items of [`Self::share_places`].
    pub const MOST_PLACES: usize = WORDS * BITS;

    /// The calling thread alone.
    #[must_use]
    pub fn alone() -> Self {
        Self::default()
    }

    /// So many threads, the calling one among them; none is as good as one.
    ///
    /// # Errors
    /// If the system refuses another thread.
    pub fn new(threads: usize) -> io::Result<Self> {
        let crew = match threads {
            0 | 1 => None,
            _ => Some(Arc::new(Crew::new(threads - 1)?)),
        };
        Ok(Self { crew })
    }

    /// As many threads as this machine runs at a time.
    ///
    /// # Errors
    /// If the system refuses another thread.
    pub fn of_all_cores() -> io::Result<Self> {
        Self::new(std::thread::available_parallelism().map_or(1, usize::from))
    }

    /// Number of threads, the calling one among them.
    #[must_use]
    pub fn size(&self) -> usize {
        self.crew.as_ref().map_or(1, |crew| crew.size() + 1)
    }

    /// Does `work` with each item. Threads take the items in their order, each the next one when it
    /// is done with its last; which thread does what is left to chance.
    ///
    /// Within `work`, and while another thread shares work with the same team, the calling thread
    /// does everything itself.
    ///
    /// # Panics
    /// If `work` does, after the items that others had begun.
    ///
    /// # Examples
    /// ```
    /// use ypsilon::team::Team;
    ///
    /// let mut squares = [0, 1, 2, 3];
    /// Team::new(2)?.share(&mut squares, |value| *value *= *value);
    /// assert_eq!(squares, [0, 1, 4, 9]);
    /// # Ok::<(), std::io::Error>(())
    /// ```
    pub fn share<I>(&self, items: I, work: impl Fn(I::Item) + Sync)
    where
        I: IntoIterator<IntoIter: Send>,
    {
        let Some(crew) = &self.crew else {
            return items.into_iter().for_each(work);
        };
        let queue = Mutex::new(items.into_iter());
        let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
        crew.run(&|_| {
            while let Some(item) = next() {
                work(item);
            }
        });
    }

    /// Does `work` with each place from 0 up to `places`, each once. As a rule a thread does the
    /// places that it did the last time, so that what belongs to them is still in its cache; those
    /// of a thread that does not come others do.
    ///
    /// # Panics
    /// If `work` does, or if there are more than [`Self::MOST_PLACES`].
    pub fn share_places(&self, places: usize, work: impl Fn(usize) + Sync) {
        assert!(places <= Self::MOST_PLACES, "{places} places");
        let Some(crew) = self.crew.as_ref().filter(|_| places > 1) else {
            return (0..places).for_each(work);
        };
        let (taken, threads) = (Taken::new(), self.size());
        let try_place = |place| {
            if taken.take(place) {
                work(place);
            }
        };
        crew.run(&|thread| {
            (thread..places).step_by(threads).for_each(try_place);
            (0..places).for_each(try_place);
        });
    }
}

/// So many items a thread can have taken before others are asked about one by one.
const WORDS: usize = 4;
/// Items to a word.
const BITS: usize = u64::BITS as usize;

/// Which of some items are taken.
struct Taken([AtomicU64; WORDS]);

impl Taken {
    fn new() -> Self {
        Self([const { AtomicU64::new(0) }; WORDS])
    }

    /// Whether the caller is the first to take an item.
    fn take(&self, item: usize) -> bool {
        let bit = 1 << (item % BITS);
        self.0[item / BITS].fetch_or(bit, Ordering::Relaxed) & bit == 0
    }
}

impl fmt::Debug for Team {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Team").field("size", &self.size()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{
        panic::{AssertUnwindSafe, catch_unwind},
        sync::atomic::AtomicUsize,
        time::Duration,
    };

    fn team(threads: usize) -> Team {
        Team::new(threads).expect("threads")
    }

    #[test]
    fn each_item_is_done_once_by_any_number_of_threads() {
        for threads in [0, 1, 2, 3, 8] {
            let team = team(threads);
            for round in 0..2000 {
                let mut counts = vec![0_u32; round % 97];
                team.share(&mut counts, |count| *count += 1);
                assert!(counts.iter().all(|&count| count == 1), "{threads} threads: {counts:?}");
            }
        }
    }

    #[test]
    fn each_place_is_visited_once() {
        for threads in [1, 2, 3, 8] {
            let team = team(threads);
            for places in [0, 1, 2, 5, 64, 65, 256] {
                let visits: Vec<AtomicUsize> = (0..places).map(|_| AtomicUsize::new(0)).collect();
                for round in 1..200 {
                    team.share_places(places, |place| {
                        visits[place].fetch_add(1, Ordering::Relaxed);
                    });
                    assert!(visits.iter().all(|v| v.load(Ordering::Relaxed) == round));
                }
            }
        }
    }

    /// Threads that went to sleep come back.
    #[test]
    fn threads_wake_up_after_a_pause() {
        let team = team(3);
        for _ in 0..3 {
            std::thread::sleep(Duration::from_millis(30));
            let arrived = AtomicUsize::new(0);
            // nobody goes on before all are there
            team.share(0..3, |_| {
                arrived.fetch_add(1, Ordering::SeqCst);
                while arrived.load(Ordering::SeqCst) < 3 {
                    std::thread::yield_now();
                }
            });
            assert_eq!(arrived.into_inner(), 3);
        }
    }

    #[test]
    fn work_within_work_is_done_by_its_own_thread() {
        let team = team(2);
        let sum = AtomicUsize::new(0);
        team.share(0..8, |i| {
            team.clone().share(0..8, |j| {
                sum.fetch_add(i * j, Ordering::Relaxed);
            });
        });
        assert_eq!(sum.into_inner(), 28 * 28);
    }

    #[test]
    fn a_panic_reaches_the_caller_and_the_team_goes_on() {
        for threads in [1, 2, 4] {
            let team = team(threads);
            for bad in 0..40 {
                let work = || team.share(0..40, |i| assert_ne!(i, bad, "item {bad}"));
                let panic = catch_unwind(AssertUnwindSafe(work)).expect_err("a panic");
                let text = panic.downcast_ref::<String>().expect("a text");
                assert!(text.contains(&format!("item {bad}")), "{text}");
                let done = AtomicUsize::new(0);
                team.share(0..40, |_| {
                    done.fetch_add(1, Ordering::Relaxed);
                });
                assert_eq!(done.into_inner(), 40);
            }
        }
    }
}
