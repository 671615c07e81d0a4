//! How output files are called.

/// Names of the files that a run of a deck writes.
///
/// Snapshots, restart decks and the mesh are called after the deck's name up to its **first** point,
/// wherever that is: for `./a.y` nothing is left, as in the original. Give the name without folder to
/// get what is meant.
///
/// ```
/// use yformat::classic_output::OutputNames;
///
/// let names = OutputNames::new("wall.dry.y");
/// assert_eq!(names.snapshot(12), "wall12.ym");
/// assert_eq!(names.restart(9), "wall9_restart.y");
/// assert_eq!(names.mesh(), "wall.msh");
/// assert_eq!(names.history(0), "wall.dry.yh0");
/// assert_eq!(OutputNames::new("./a.y").mesh(), ".msh");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutputNames<'a> {
    deck: &'a str,
}

impl<'a> OutputNames<'a> {
    /// The file of the contact forces, whatever the deck is called.
    pub const CONTACT_FORCES: &'static str = "contactforce.txt";

    /// Names for a run of `deck`.
    #[must_use]
    pub fn new(deck: &'a str) -> Self {
        Self { deck }
    }

    /// What the names begin with.
    #[must_use]
    pub fn base(&self) -> &'a str {
        self.deck.split_once('.').map_or(self.deck, |(base, _)| base)
    }

    /// Snapshot with this number (`ICOUTI` when it is written).
    #[must_use]
    pub fn snapshot(&self, number: i64) -> String {
        format!("{}{number}.ym", self.base())
    }

    /// Restart deck written after the snapshot with this number.
    #[must_use]
    pub fn restart(&self, snapshot: i64) -> String {
        format!("{}{snapshot}_restart.y", self.base())
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> String {
        format!("{}.msh", self.base())
    }

    /// History with this number.
    #[must_use]
    pub fn history(&self, number: usize) -> String {
        format!("{}h{number}", self.deck)
    }
}
