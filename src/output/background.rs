//! Files written by a thread of their own while the run goes on.

use super::OutputError;
use std::{
    io,
    sync::{
        Arc, Mutex, PoisonError,
        mpsc::{SyncSender, sync_channel},
    },
    thread::{Builder, JoinHandle},
};

/// Jobs that wait while another one is done. What they hold is memory: whoever is faster than the
/// disk has to wait.
const WAITING: usize = 1;

/// Something to write: what is needed for it is in it.
type Job = Box<dyn FnOnce() -> Result<(), OutputError> + Send>;

/// What the thread is told.
enum Order {
    Write(Job),
    /// To tell that all earlier orders are done.
    Report(SyncSender<()>),
}

struct Worker {
    orders: SyncSender<Order>,
    thread: JoinHandle<()>,
}

#[derive(Default)]
struct Shared {
    /// Started by the first job.
    worker: Mutex<Option<Worker>>,
    /// Why a job failed. Nothing is written after it.
    failure: Arc<Mutex<Failure>>,
}

#[derive(Debug, Default)]
enum Failure {
    #[default]
    None,
    /// To be reported.
    New(OutputError),
    Reported,
}

/// Writes files in the order in which they are handed over, in a thread of its own. Clones are
/// the same thread. When the last one is dropped, all has been written.
#[derive(Clone, Default)]
pub struct Background {
    shared: Arc<Shared>,
}

impl Background {
    /// Without a thread as long as nothing is to be written.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Hands over a job; waits while too many wait already.
    ///
    /// # Errors
    /// If an earlier job failed: that job's error, once. Later jobs are not done.
    pub fn submit(
        &self,
        job: impl FnOnce() -> Result<(), OutputError> + Send + 'static,
    ) -> Result<(), OutputError> {
        self.report()?;
        self.send(Order::Write(Box::new(job)))
    }

    /// Waits until all jobs are done.
    ///
    /// # Errors
    /// If one of them failed and that was not reported yet.
    pub fn wait(&self) -> Result<(), OutputError> {
        let is_idle = lock(&self.shared.worker).is_none();
        if !is_idle {
            let (done, is_done) = sync_channel(1);
            self.send(Order::Report(done))?;
            is_done.recv().map_err(|_| gone())?;
        }
        self.report()
    }

    /// The error of a job that failed, once.
    fn report(&self) -> Result<(), OutputError> {
        let mut failure = lock(&self.shared.failure);
        match std::mem::take(&mut *failure) {
            Failure::None => Ok(()),
            Failure::Reported => {
                *failure = Failure::Reported;
                Ok(())
            }
            Failure::New(error) => {
                *failure = Failure::Reported;
                Err(error)
            }
        }
    }

    fn send(&self, order: Order) -> Result<(), OutputError> {
        let orders = {
            let mut worker = lock(&self.shared.worker);
            match &*worker {
                Some(worker) => worker.orders.clone(),
                None => {
                    let started = start(&self.shared.failure);
                    worker.insert(started.map_err(OutputError::io("result files"))?).orders.clone()
                }
            }
        };
        orders.send(order).map_err(|_| gone())
    }
}

impl Drop for Shared {
    fn drop(&mut self) {
        let worker = self.worker.get_mut().unwrap_or_else(PoisonError::into_inner).take();
        if let Some(Worker { orders, thread }) = worker {
            drop(orders);
            // a panic has been printed by the thread itself
            let _ = thread.join();
        }
    }
}

fn start(failure: &Arc<Mutex<Failure>>) -> io::Result<Worker> {
    let (orders, received) = sync_channel::<Order>(WAITING);
    let failure = Arc::clone(failure);
    let work = move || {
        for order in received {
            match order {
                Order::Write(job) => {
                    if !matches!(*lock(&failure), Failure::None) {
                        continue;
                    }
                    if let Err(error) = job() {
                        *lock(&failure) = Failure::New(error);
                    }
                }
                // whoever asked may have gone
                Order::Report(done) => drop(done.send(())),
            }
        }
    };
    let thread = Builder::new().name("result files".into()).spawn(work)?;
    Ok(Worker { orders, thread })
}

/// The thread has ended although files were still to come.
fn gone() -> OutputError {
    OutputError::io("result files")(io::Error::other("the thread that writes them has ended"))
}

/// What the mutex holds: a thread that panicked with it has said so itself.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{
        sync::{
            atomic::{AtomicUsize, Ordering},
            mpsc::channel,
        },
        thread,
        time::Duration,
    };

    fn full() -> OutputError {
        OutputError::io("half.vtu")(io::Error::new(io::ErrorKind::StorageFull, "no space left"))
    }

    #[test]
    fn jobs_are_done_in_order_and_waited_for() {
        let background = Background::new();
        let done = Arc::new(Mutex::new(Vec::new()));
        for number in 0..20 {
            let done = Arc::clone(&done);
            let job = move || {
                lock(&done).push(number);
                Ok(())
            };
            background.submit(job).expect("accepted");
        }
        background.wait().expect("all done");
        assert_eq!(*lock(&done), (0..20).collect::<Vec<_>>());
    }

    /// One job is done, one waits; the third has to wait for its turn to be handed over.
    #[test]
    fn no_more_than_a_bounded_number_waits() {
        let background = Background::new();
        let (release, released) = channel::<()>();
        let handed_over = Arc::new(AtomicUsize::new(0));
        let counted = Arc::clone(&handed_over);
        let hand_over = move || {
            let released = Arc::new(Mutex::new(released));
            for _ in 0..6 {
                let released = Arc::clone(&released);
                let job = move || {
                    lock(&released).recv().expect("released");
                    Ok(())
                };
                background.submit(job).expect("accepted");
                counted.fetch_add(1, Ordering::SeqCst);
            }
            background.wait()
        };
        let run = thread::spawn(hand_over);
        for released in 0..6 {
            thread::sleep(Duration::from_millis(20));
            let most = released + 1 + WAITING;
            assert!(handed_over.load(Ordering::SeqCst) <= most, "more than {most} were accepted");
            release.send(()).expect("a job waits");
        }
        run.join().expect("no panic").expect("all done");
    }

    #[test]
    fn an_error_is_reported_once_and_nothing_is_written_after_it() {
        let background = Background::new();
        background.submit(|| Err(full())).expect("accepted");
        let later = Arc::new(AtomicUsize::new(0));
        let counted = Arc::clone(&later);
        let count = move || {
            counted.fetch_add(1, Ordering::SeqCst);
            Ok(())
        };
        // accepted or not: the error comes here or from `wait`
        let submitted = background.submit(count.clone());
        let error = submitted.and_then(|()| background.wait()).expect_err("the disk is full");
        assert_eq!(error.to_string(), "cannot write half.vtu: no space left");
        background.submit(count).expect("has been reported");
        background.wait().expect("has been reported");
        assert_eq!(later.load(Ordering::SeqCst), 0);
    }

    #[test]
    fn all_is_written_when_the_last_clone_is_dropped() {
        let done = Arc::new(AtomicUsize::new(0));
        let background = Background::new();
        let counted = Arc::clone(&done);
        let job = move || {
            thread::sleep(Duration::from_millis(20));
            counted.fetch_add(1, Ordering::SeqCst);
            Ok(())
        };
        background.clone().submit(job).expect("accepted");
        drop(background);
        assert_eq!(done.load(Ordering::SeqCst), 1);
    }
}
