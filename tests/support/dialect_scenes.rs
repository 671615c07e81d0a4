//! Scenes of decks of other dialects that nothing moves but what a test does.

use super::{stability_scenes::Moving, ten_node_cube::confined_cube_of_ten_nodes};
use std::{fs, path::Path};
use ypsilon::{
    scene::{Condition, Profile, Scene},
    session::load,
    simulation::{AnySimulation, SolverOptions},
};

/// The scene of a deck of `tests/data` without what moves it: what is held stays held.
pub fn left_alone(deck: &str) -> Moving {
    of_file(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(deck), false)
}

/// The thesis's cube of twelve tetrahedra of ten nodes, that nothing holds.
pub fn free_cube_of_ten_nodes() -> Moving {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("cube.Y3D");
    fs::write(&path, confined_cube_of_ten_nodes(0.2).0).expect("a deck");
    of_file(&path, true)
}

fn of_file(path: &Path, is_free: bool) -> Moving {
    let loaded = load(path, None, Profile::default(), SolverOptions::default());
    let loaded = loaded.unwrap_or_else(|fault| panic!("{}: {fault:?}", path.display()));
    match loaded.simulation.expect("a deck that runs") {
        AnySimulation::Plane(mut simulation) => {
            let scene = still(simulation.scene().clone(), is_free);
            simulation.continue_with(scene, None);
            Moving::Plane(simulation)
        }
        AnySimulation::Spatial(mut simulation) => {
            let scene = still(simulation.scene().clone(), is_free);
            simulation.continue_with(scene, None);
            Moving::Space(simulation)
        }
    }
}

fn still<const D: usize>(mut scene: Scene<D>, is_free: bool) -> Scene<D> {
    scene.control.gravity = [0.0; 3];
    scene.nodes.velocity.fill(nalgebra::SVector::zeros());
    for set in &mut scene.node_sets {
        set.amplitudes = [0.0; D];
        set.acceleration = [0.0; D];
        (set.pressure, set.traction) = (0.0, 0.0);
        if is_free {
            set.conditions = [Condition::Force; D];
        }
    }
    if is_free {
        scene.materials.iter_mut().for_each(|material| material.viscosity = 0.0);
    }
    scene
}
