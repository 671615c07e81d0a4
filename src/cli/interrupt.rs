use std::sync::{
    OnceLock,
    atomic::{AtomicBool, Ordering},
};

static INTERRUPTED: AtomicBool = AtomicBool::new(false);
static INSTALLED: OnceLock<()> = OnceLock::new();

/// Makes Ctrl-C end the run at its next step; a second one ends the program
/// at once.
pub(super) fn install() {
    INSTALLED.get_or_init(|| {
        // without handler Ctrl-C ends the program as usual: no reason to refuse the run
        let _ = ctrlc::set_handler(|| {
            if INTERRUPTED.swap(true, Ordering::Relaxed) {
                std::process::exit(super::Exit::Interrupted as i32);
            }
        });
    });
}

/// Makes the end of the standard input end the run at its next step. Who starts runs and holds the
/// other end of a pipe ends them by letting go of it, on every system, and they end with it when it
/// is killed.
pub(super) fn watch_input() {
    std::thread::spawn(|| {
        // an input that cannot be read has ended, too
        let _ = std::io::copy(&mut std::io::stdin().lock(), &mut std::io::sink());
        INTERRUPTED.store(true, Ordering::Relaxed);
    });
}

/// Whether Ctrl-C was pressed.
pub(super) fn is_requested() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
