use thiserror::Error;

/// Why a scene has no state of rest that settling could look for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum Unsettleable {
    /// Relaxation knows triangles only.
    #[error("it is three-dimensional, and settling works in 2D only")]
    Space,
    /// Rigid triangles have no stiffness that a fictitious mass could follow.
    #[error("it has rigid triangles (type 2), which move with masses of their own")]
    RigidTriangles,
    /// Absorbing boundaries hold nothing at rest.
    #[error(
        "it has absorbing boundaries (code 4), which resist velocities and hold nothing at rest"
    )]
    AbsorbingBoundaries,
    /// Softening triangles that detach leave holes in the course of settling.
    #[error(
        "it has softening triangles that break away (type 4 with I1PEFR), which settling does not follow"
    )]
    BreakingTriangles,
    /// Excavated triangles are moved out of the way in every step.
    #[error("it has excavated triangles (I1PEXC), which are moved out of the way in every step")]
    Excavation,
    /// Nothing can move.
    #[error("no node is free to move")]
    NoFreeNode,
    /// Nothing can stop what moves.
    #[error("no node is held, so that nothing stops what gravity pulls")]
    NothingHeld,
    /// Nothing acts.
    #[error(
        "no load acts at its first instant: no gravity, force, acceleration, pressure, traction or stress in situ"
    )]
    NoLoad,
    /// Something moves from the start.
    #[error("node {node} has an initial velocity, which settling would take away")]
    Moving {
        /// Number of the node in the deck, from 0.
        node: usize,
    },
    /// The scene has run already.
    #[error("it goes on from a checkpoint: settling comes before the first step of a run")]
    Resumed,
}

/// Why a scene was not brought to rest.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum SettlingFault {
    /// It has no state of rest that settling could look for.
    #[error("this scene cannot be settled: {0}. Run it without --settle")]
    Refused(#[from] Unsettleable),
    /// The tolerance is no number above 0.
    #[error("a tolerance of {0} cannot be reached; expected a number above 0, such as 1e-4")]
    Tolerance(f64),
    /// It did not come to rest.
    #[error(
        "the scene has not settled: after {iterations} iterations {:.3} % of the loads act and the unbalanced \
         force ratio is {ratio:.3e}; expected {tolerance:.3e} or less. Either nothing holds some part of it (then \
         run it without --settle), or it needs more iterations (--settle-steps) or a larger tolerance \
         (--settle-tolerance)",
        100.0 * load
    )]
    NotSettled {
        /// Iterations done.
        iterations: u64,
        /// Unbalanced force ratio at the end.
        ratio: f64,
        /// Share of the loads that acted at the end.
        load: f64,
        /// Ratio asked for.
        tolerance: f64,
    },
    /// No fictitious masses were found with which the motion is stable.
    #[error(
        "settling is unstable: forces grow without bound whatever the fictitious masses. The scene may be flying \
         apart from its first step (overlapping bodies, penalties out of proportion): see what it does without --settle"
    )]
    Unstable,
}
