use indicatif::{MultiProgress, ProgressBar, ProgressStyle};
use std::path::Path;

/// Bars for the files and for the states of one file; nothing where the error stream is no
/// terminal.
pub(super) struct Bar {
    both: MultiProgress,
    files: ProgressBar,
    states: ProgressBar,
}

impl Bar {
    pub fn new(files: usize) -> Self {
        let both = MultiProgress::new();
        let style = |template| {
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
        };
        let of_files = both.add(ProgressBar::new(files as u64));
        of_files.set_style(style("{bar:24} file {pos} of {len}  {msg}"));
        let states = both.add(ProgressBar::no_length());
        states.set_style(style("{bar:24} state {pos} of {len}"));
        Self { both, files: of_files, states }
    }

    pub fn starts(&self, input: &Path) {
        self.files.set_message(input.display().to_string());
        self.states.set_length(0);
        self.states.set_position(0);
    }

    /// Is told how many states are done and how many there are.
    pub fn counter(&self) -> impl FnMut(usize, usize) {
        |done, total| {
            self.states.set_length(total as u64);
            self.states.set_position(done as u64);
        }
    }

    /// Prints without disturbing the bars.
    pub fn suspend<T>(&self, print: impl FnOnce() -> T) -> T {
        self.both.suspend(print)
    }

    pub fn done(&self) {
        self.files.inc(1);
    }

    pub fn finish(&self) {
        self.states.finish_and_clear();
        self.files.finish_and_clear();
    }
}
