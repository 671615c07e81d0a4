//! Options of settling, for the commands that run decks.

use crate::simulation::SettlingOptions;
use clap::Args;

/// Whether the deck is brought to rest before its first step.
#[derive(Debug, Args)]
pub(super) struct SettleArguments {
    /// Bring the deck to rest under the loads of its first instant before the first step, by
    /// dynamic relaxation: many times faster than waiting for it. Results then begin with the
    /// settled state
    #[arg(long, conflicts_with = "resume")]
    settle: bool,
    /// Unbalanced force ratio at which the deck counts as settled: largest residual nodal force
    /// over mean nodal load
    #[arg(long, value_name = "RATIO", requires = "settle", default_value_t = SettlingOptions::TOLERANCE)]
    settle_tolerance: f64,
    /// Iterations after which settling is given up
    #[arg(long, value_name = "N", requires = "settle",
          value_parser = clap::value_parser!(u64).range(1..),
          default_value_t = SettlingOptions::MOST_ITERATIONS)]
    settle_steps: u64,
}

impl SettleArguments {
    /// The options, if settling is asked for.
    pub fn options(&self) -> Option<SettlingOptions> {
        self.settle.then_some(SettlingOptions {
            tolerance: self.settle_tolerance,
            most_iterations: self.settle_steps,
        })
    }
}
