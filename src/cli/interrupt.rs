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

/// Whether Ctrl-C was pressed.
pub(super) fn is_requested() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
