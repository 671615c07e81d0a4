/// Time stepping, gravity and output intervals.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Index of the first step.
    pub first_step: u64,
    /// One past the index of the last step.
    pub end_step: u64,
    /// Time step, s.
    pub time_step: f64,
    /// Physical time at the first step, s.
    pub start_time: f64,
    /// Acceleration of gravity, m/s² (y negative: downwards). In 2D only the y component acts,
    /// as in the original.
    pub gravity: [f64; 3],
    /// A result state is written at every step whose index is a multiple of this.
    pub output_interval: u64,
    /// Another interval once joints have broken (Y-Geo).
    pub refined_output: Option<RefinedOutput>,
    /// A row of the run table is written at every multiple of this step index.
    pub table_interval: u64,
}

/// Output interval of a scene in which joints have broken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RefinedOutput {
    /// Steps from one state to the next.
    pub interval: u64,
    /// It counts once more joints than these are broken.
    pub broken_joints: u64,
}
