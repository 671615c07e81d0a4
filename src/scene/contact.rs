/// Settings of contact detection and of the couple list.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSettings {
    /// Buffer around elements, m: detection is due when the accumulated travel
    /// reaches it, and separated couples are dropped at twice this distance.
    pub buffer: f64,
    /// Travel accumulated since the last detection at the start, m; a value of
    /// at least `buffer` forces detection in the first step.
    pub initial_travel: f64,
    /// Whether every element takes part and contact tags are ignored.
    pub all_elements: bool,
    /// Sliding of the couple slots at the start, m².
    pub initial_sliding: Vec<[f64; 6]>,
}
