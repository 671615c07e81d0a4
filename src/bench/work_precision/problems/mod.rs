//! The problems, one file each.

mod bar_wave;
mod bar_wave_3d;
mod column;
mod impact;
mod impact_3d;
mod patch;
mod sliding_block;
mod two_bars;

use super::problem::Problem;

/// All problems.
pub const PROBLEMS: [&dyn Problem; 8] = [
    &bar_wave::BarWave,
    &patch::Patch,
    &sliding_block::SlidingBlock,
    &impact::Impact,
    &two_bars::TwoBarsContact,
    &column::SelfWeight,
    &bar_wave_3d::BarWave3d,
    &impact_3d::Impact3d,
];
