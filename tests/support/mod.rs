//! What several test files share.
#![allow(dead_code, reason = "each test file uses its part")]

pub mod block_deck;
pub mod child;
pub mod dialect_cases;
pub mod dialect_scenes;
pub mod dump;
pub mod grid_deck;
pub mod largest_allocation;
pub mod plate_deck;
pub mod result_files;
pub mod results;
pub mod scenes;
pub mod settling;
pub mod spoilt_deck;
pub mod stability_scenes;
pub mod state_file;
pub mod ten_node_cube;
