use std::{
    any::Any,
    cell::UnsafeCell,
    hint, io,
    panic::{AssertUnwindSafe, catch_unwind, resume_unwind},
    sync::{
        Arc, Condvar, Mutex, MutexGuard, PoisonError, TryLockError,
        atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering::SeqCst},
    },
    thread::{self, JoinHandle},
};

/// What the threads of a crew do; each calls it once, with its number.
type Job = dyn Fn(usize) + Sync;

/// The state's bit that says that a job may be begun.
const OPEN: u64 = 1 << 31;
/// The state's part that counts the threads at work.
const AT_WORK: u64 = OPEN - 1;
/// The state's part that numbers the jobs, and one of them.
const ONE_JOB: u64 = 1 << 32;

/// So often a thread looks for work without leaving its core, about 20 µs,
const SPINS: u32 = 1000;
/// then so often giving its core to who else wants it, about 0.2 ms, before it goes to sleep.
const YIELDS: u32 = 500;

/// Threads that wait for jobs.
pub(super) struct Crew {
    shared: Arc<Shared>,
    threads: Vec<JoinHandle<()>>,
    /// Held by the thread whose job is being done.
    caller: Mutex<()>,
}

struct Shared {
    /// Number of the job, whether it may be begun, and how many threads are at work on it.
    state: AtomicU64,
    /// The job. It is written only while the state is not open and nobody is at work.
    job: UnsafeCell<Option<*const Job>>,
    /// What the first thread that panicked said.
    panic: Mutex<Option<Box<dyn Any + Send>>>,
    ends: AtomicBool,
    asleep: AtomicUsize,
    bed: Mutex<()>,
    bell: Condvar,
}

// SAFETY: `job` points to something `Sync`; it is written by the thread that holds `caller` while
// nobody reads it (see `Crew::run`), and read by threads that have entered an open state
unsafe impl Sync for Shared {}
// SAFETY: as above; nothing in it belongs to a thread
unsafe impl Send for Shared {}

impl Crew {
    pub fn new(threads: usize) -> io::Result<Self> {
        let shared = Arc::new(Shared {
            state: AtomicU64::new(0),
            job: UnsafeCell::new(None),
            panic: Mutex::new(None),
            ends: AtomicBool::new(false),
            asleep: AtomicUsize::new(0),
            bed: Mutex::new(()),
            bell: Condvar::new(),
        });
        let mut crew = Self { shared, threads: Vec::new(), caller: Mutex::new(()) };
        for number in 1..=threads {
            let shared = crew.shared.clone();
            let name = format!("team-{number}");
            // if this fails, those that there are end with the crew
            let thread = thread::Builder::new().name(name).spawn(move || shared.serve(number))?;
            crew.threads.push(thread);
        }
        Ok(crew)
    }

    /// Number of threads.
    pub fn size(&self) -> usize {
        self.threads.len()
    }

    /// Does the job on the calling thread, which is number 0, and on those of the crew that come in
    /// time. The calling thread alone does it if another one is using the crew.
    pub fn run(&self, job: &(dyn Fn(usize) + Sync)) {
        let _caller = match self.caller.try_lock() {
            Ok(guard) => guard,
            Err(TryLockError::Poisoned(error)) => error.into_inner(),
            Err(TryLockError::WouldBlock) => return job(0),
        };
        let shared = &*self.shared;
        // SAFETY: the state is not open and nobody is at work: at the beginning, and because `run`
        // ends with it. `caller` keeps others out. The lifetime is that of this call at least, and
        // nobody has the job after it.
        unsafe {
            *shared.job.get() =
                Some(std::mem::transmute::<*const (dyn Fn(usize) + Sync + '_), *const Job>(job));
        }
        let number = (shared.state.load(SeqCst) & !(OPEN | AT_WORK)).wrapping_add(ONE_JOB);
        shared.state.store(number | OPEN, SeqCst);
        shared.wake();
        let outcome = catch_unwind(AssertUnwindSafe(|| job(0)));
        // from here on nobody begins it
        shared.state.fetch_and(!OPEN, SeqCst);
        let mut rounds = 0;
        while shared.state.load(SeqCst) & AT_WORK != 0 {
            wait_a_little(&mut rounds);
        }
        let panic = lock(&shared.panic).take();
        if let Some(panic) = outcome.err().or(panic) {
            resume_unwind(panic);
        }
    }
}

impl Drop for Crew {
    fn drop(&mut self) {
        self.shared.ends.store(true, SeqCst);
        self.shared.wake();
        for thread in self.threads.drain(..) {
            // jobs' panics do not end threads
            let _ = thread.join();
        }
    }
}

impl Shared {
    /// Does one job after the other.
    fn serve(&self, number: usize) {
        let mut last = 0;
        while let Some(state) = self.next_job(last) {
            let entered = state + 1;
            if self.state.compare_exchange(state, entered, SeqCst, SeqCst).is_err() {
                continue;
            }
            last = state & !(OPEN | AT_WORK);
            // SAFETY: the state was open when this thread entered it, so that the job is written
            // and its lender waits until nobody is at work
            let job = unsafe { (*self.job.get()).map(|job| &*job) };
            if let Some(Err(panic)) = job.map(|job| catch_unwind(AssertUnwindSafe(|| job(number))))
            {
                lock(&self.panic).get_or_insert(panic);
            }
            self.state.fetch_sub(1, SeqCst);
        }
    }

    /// The state, once it is open for another job than the last; none when the crew ends.
    fn next_job(&self, last: u64) -> Option<u64> {
        let mut rounds = 0;
        loop {
            if self.ends.load(SeqCst) {
                return None;
            }
            let state = self.state.load(SeqCst);
            if state & OPEN != 0 && state & !(OPEN | AT_WORK) != last {
                return Some(state);
            }
            if rounds < SPINS + YIELDS {
                wait_a_little(&mut rounds);
            } else {
                self.sleep(state);
                rounds = 0;
            }
        }
    }

    /// Sleeps until somebody rings, unless the state has changed or the crew ends.
    fn sleep(&self, state: u64) {
        let bed = lock(&self.bed);
        // who changes the state looks afterwards whether somebody sleeps
        self.asleep.fetch_add(1, SeqCst);
        if self.state.load(SeqCst) == state && !self.ends.load(SeqCst) {
            drop(self.bell.wait(bed).unwrap_or_else(PoisonError::into_inner));
        }
        self.asleep.fetch_sub(1, SeqCst);
    }

    fn wake(&self) {
        if self.asleep.load(SeqCst) > 0 {
            drop(lock(&self.bed));
            self.bell.notify_all();
        }
    }
}

fn wait_a_little(rounds: &mut u32) {
    if *rounds < SPINS {
        hint::spin_loop();
    } else {
        thread::yield_now();
    }
    *rounds = rounds.saturating_add(1);
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
