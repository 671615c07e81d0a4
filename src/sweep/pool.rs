//! Many cases at once.

use super::{
    error::SweepError,
    record::{Record, State},
    run_case::Runner,
    study::{Case, Study},
};
use std::{
    sync::{
        atomic::{AtomicBool, AtomicUsize, Ordering},
        mpsc,
    },
    thread,
};

/// Something that happened to a case.
#[derive(Debug)]
pub enum Event<'a> {
    /// It was started.
    Started(&'a Case),
    /// It is over, or interrupted.
    Ended(&'a Case, &'a Record),
}

/// How many cases run at once, and on how many threads each: as many as there are cores, unless
/// told otherwise, and threads where there are more cores than cases.
#[must_use]
pub fn jobs_and_threads(
    cores: usize,
    cases: usize,
    jobs: Option<usize>,
    threads: Option<usize>,
) -> (usize, usize) {
    let cores = cores.max(1);
    let by_threads = threads.map_or(cores, |threads| (cores / threads.max(1)).max(1));
    let jobs = jobs.unwrap_or(by_threads).clamp(1, cases.max(1));
    (jobs, threads.unwrap_or((cores / jobs).max(1)))
}

impl Study {
    /// Runs cases, `jobs` at a time, and gives their records. When `wants_stop` says so no further
    /// ones are begun, and those that run are interrupted.
    ///
    /// # Errors
    /// The first that hinders a case; the others are ended in a state that can be gone on from.
    pub fn run_cases(
        &self,
        cases: &[&Case],
        jobs: usize,
        runner: &Runner,
        wants_stop: &(dyn Fn() -> bool + Sync),
        watch: &mut dyn FnMut(Event<'_>),
    ) -> Result<Vec<Record>, SweepError> {
        enum News<'a> {
            Started(&'a Case),
            Ended(&'a Case, Box<Result<Record, SweepError>>),
        }
        let (next, broken) = (AtomicUsize::new(0), AtomicBool::new(false));
        let stops = || broken.load(Ordering::Relaxed) || wants_stop();
        let (sender, receiver) = mpsc::channel();
        let mut records = Vec::new();
        let mut failure = None;
        thread::scope(|scope| {
            for _ in 0..jobs {
                let (sender, next, stops) = (sender.clone(), &next, &stops);
                scope.spawn(move || {
                    while !stops() {
                        let Some(case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) else {
                            return;
                        };
                        // nobody listens only when everything is over
                        let _ = sender.send(News::Started(case));
                        let outcome = self.run_case(case, runner, stops);
                        let _ = sender.send(News::Ended(case, Box::new(outcome)));
                    }
                });
            }
            drop(sender);
            for news in receiver {
                match news {
                    News::Started(case) => watch(Event::Started(case)),
                    News::Ended(case, outcome) => match *outcome {
                        Ok(record) => {
                            watch(Event::Ended(case, &record));
                            records.push(record);
                        }
                        Err(error) => {
                            broken.store(true, Ordering::Relaxed);
                            failure.get_or_insert(error);
                        }
                    },
                }
            }
        });
        records.sort_by_key(|record: &Record| record.case);
        failure.map_or(Ok(records), Err)
    }

    /// The records of all cases, with the outputs that are asked for now; none for those that
    /// have not begun.
    ///
    /// # Errors
    /// If a record cannot be written.
    pub fn records(&self) -> Result<Vec<Option<Record>>, SweepError> {
        let of_case = |case: &Case| {
            self.record(case).map(|record| self.with_outputs(case, record)).transpose()
        };
        self.cases.iter().map(of_case).collect()
    }

    /// The cases that are still to be run.
    ///
    /// # Errors
    /// If a record cannot be written.
    pub fn to_do(&self, retries: bool) -> Result<Vec<&Case>, SweepError> {
        let is_over = |record: &Option<Record>| {
            record.as_ref().is_some_and(|record| {
                record.state == State::Ended
                    && !record.is_to_blame_on_the_machine()
                    && !(retries && record.has_failed())
            })
        };
        let records = self.records()?;
        let open = self.cases.iter().zip(&records).filter(|(_, record)| !is_over(record));
        Ok(open.map(|(case, _)| case).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::jobs_and_threads;

    #[test]
    fn cores_are_shared_sensibly() {
        // cores, cases, jobs, threads
        assert_eq!(jobs_and_threads(8, 100, None, None), (8, 1));
        assert_eq!(jobs_and_threads(8, 3, None, None), (3, 2));
        assert_eq!(jobs_and_threads(8, 1, None, None), (1, 8));
        assert_eq!(jobs_and_threads(8, 100, Some(2), None), (2, 4));
        assert_eq!(jobs_and_threads(8, 100, None, Some(4)), (2, 4));
        assert_eq!(jobs_and_threads(2, 100, Some(6), None), (6, 1));
        assert_eq!(jobs_and_threads(2, 100, None, Some(16)), (1, 16));
        assert_eq!(jobs_and_threads(2, 0, None, None), (1, 2));
    }
}
