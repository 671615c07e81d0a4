//! Scenes whose speed is measured.

mod blocks;
mod plane_deck;
mod sheet;

use super::BenchError;
use crate::meshing::{
    Scenario,
    kinds::Bridge,
    spatial::kinds::{BrickBond, Wall3d},
};
use plane_deck::PlaneDeck;
use std::path::{Path, PathBuf};
use yformat::deck::Deck;

/// A scene that Ypsilon makes itself.
#[derive(Debug, Clone, Copy)]
pub struct Scene {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it is, in one line.
    pub about: &'static str,
    /// Triangles that it has if nothing else is asked for, about; 0 where it has one size.
    pub triangles: usize,
    /// Steps that take about a second.
    pub steps: u64,
    maker: Maker,
}

/// How the deck of a scene is made.
#[derive(Debug, Clone, Copy)]
enum Maker {
    /// From nodes and triangles, as many as are asked for.
    Plane(fn(usize) -> PlaneDeck),
    /// By the bridge generator, as it is.
    Bridge,
    /// A wall in space, as it is.
    Wall(fn() -> Wall3d),
}

/// All scenes that Ypsilon makes itself; the first four are the original's speed scenes.
pub const SCENES: [Scene; 8] = [
    Scene {
        name: "elastic",
        about: "elastic sheet, no contact, no joints",
        triangles: 5000,
        steps: 10_000,
        maker: Maker::Plane(sheet::elastic),
    },
    Scene {
        name: "jointed-nocontact",
        about: "sheet with joints between all triangles, no contact",
        triangles: 5000,
        steps: 3000,
        maker: Maker::Plane(sheet::jointed),
    },
    Scene {
        name: "jointed",
        about: "the same with contact: bonded neighbours are couples",
        triangles: 5000,
        steps: 1000,
        maker: Maker::Plane(sheet::jointed_in_contact),
    },
    Scene {
        name: "blocks",
        about: "dry blocks of 4 triangles in running bond",
        triangles: 2160,
        steps: 2000,
        maker: Maker::Plane(blocks::running_bond),
    },
    Scene {
        name: "bridge",
        about: "masonry arch bridge of `ypsilon mesh bridge`: joints, mortar, contact",
        triangles: 0,
        steps: 2000,
        maker: Maker::Bridge,
    },
    Scene {
        name: "debris",
        about: "sheet that bursts: all joints break, the debris press on each other",
        triangles: 5000,
        steps: 1000,
        maker: Maker::Plane(sheet::debris),
    },
    Scene {
        name: "wall-3d",
        about: "wall of a thousand mortared bricks, in space: joints between all tetrahedra, no contact",
        triangles: 0,
        steps: 200,
        maker: Maker::Wall(mortared_wall),
    },
    Scene {
        name: "wall-3d-dry",
        about: "dry wall of 126 bricks, in space: each lies on others",
        triangles: 0,
        steps: 200,
        maker: Maker::Wall(dry_wall),
    },
];

/// As large as the wall of `examples/solids/wall-3d`.
fn mortared_wall() -> Wall3d {
    Wall3d {
        bricks: 20,
        courses: 25,
        bond: BrickBond::Running,
        cells: [2, 1, 1],
        bonded: true,
        contact_at_cracks: true,
        ..Wall3d::default()
    }
}

fn dry_wall() -> Wall3d {
    Wall3d { bricks: 10, courses: 12, leaves: 1, bond: BrickBond::Running, ..Wall3d::default() }
}

impl Scene {
    /// The scene of a name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        SCENES.iter().find(|scene| scene.name == name)
    }

    /// Whether it can be made in any size.
    #[must_use]
    pub fn grows(&self) -> bool {
        matches!(self.maker, Maker::Plane(_))
    }

    /// The deck, for so many steps, of about so many triangles if it [grows](Self::grows).
    ///
    /// # Errors
    /// If the generator fails.
    pub fn deck(&self, triangles: usize, steps: u64) -> Result<Deck, BenchError> {
        match self.maker {
            Maker::Plane(make) => Ok(make(triangles).build(steps)),
            Maker::Bridge => {
                let bridge = Some(Bridge::default());
                of_scenario(Scenario { bridge, ..Scenario::default() }, steps)
            }
            Maker::Wall(make) => {
                let wall_3d = Some(make());
                of_scenario(Scenario { wall_3d, ..Scenario::default() }, steps)
            }
        }
    }
}

/// A scenario for so many steps of its own length.
fn of_scenario(mut scenario: Scenario, steps: u64) -> Result<Deck, BenchError> {
    let step_s = scenario.generate_any()?.step_s();
    let end_s = step_s * steps as f64;
    scenario.run.step_s = Some(step_s);
    scenario.run.end_s = Some(end_s);
    scenario.run.output_s = Some(end_s);
    Ok(scenario.generate_any()?.deck().clone())
}

/// A deck of somebody else's, where it is found beside the working folder: the masonry deck and
/// the speed scenes that the original's figures were measured with.
#[must_use]
pub fn found_decks(folder: &Path) -> Vec<(String, PathBuf)> {
    let known = [
        ("granada", "thirdparty/masonry/actual.y"),
        ("elastic5k.y", "perf/elastic5k.y"),
        ("jointed5k_nocontact.y", "perf/jointed5k_nocontact.y"),
        ("jointed5k.y", "perf/jointed5k.y"),
        ("blocks2k.y", "perf/blocks2k.y"),
        ("heap3d.y", "perf/heap3d.y"),
    ];
    let shared = folder.join("../shared");
    let found = known.into_iter().map(|(name, path)| (name.to_owned(), shared.join(path)));
    found.filter(|(_, path)| path.is_file()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        bench::work_precision::Stepped,
        scene::{Profile, SpatialContact, from_deck, spatial_from_deck},
        simulation::{Simulation, SpatialSimulation},
    };
    use yformat::database::Database;

    fn database(deck: &Deck) -> Database {
        let mut database = Database::new(deck.dialect());
        for item in deck.stages()[0].items.clone() {
            let findings = database.apply(deck, item);
            assert!(findings.iter().all(|f| !f.is_error()), "{findings:?}");
        }
        database
    }

    fn simulation(deck: &Deck) -> Simulation {
        let outcome = from_deck(deck, &database(deck), "test", Profile::default());
        let scene = outcome.scene.unwrap_or_else(|| panic!("{:?}", outcome.findings));
        let mut simulation = Simulation::new(scene);
        simulation.prepare().expect("room for joints");
        simulation
    }

    fn simulation_in_space(deck: &Deck) -> SpatialSimulation {
        let (profile, contact) = (Profile::default(), SpatialContact::default());
        let outcome = spatial_from_deck(deck, &database(deck), "test", profile, contact);
        let scene = outcome.scene.unwrap_or_else(|| panic!("{:?}", outcome.findings));
        let mut simulation = SpatialSimulation::new(scene);
        simulation.prepare().expect("room for joints");
        simulation
    }

    #[test]
    fn all_scenes_make_decks_that_run() {
        for scene in &SCENES {
            let deck = scene.deck(300, 10).expect("a deck");
            let mut moving: Box<dyn Stepped> = match scene.maker {
                Maker::Plane(_) | Maker::Bridge => Box::new(simulation(&deck)),
                Maker::Wall(_) => Box::new(simulation_in_space(&deck)),
            };
            (0..10).for_each(|_| moving.step());
            let energy = moving.kinetic_energy();
            assert!(energy.is_finite() && energy > 0.0, "{}", scene.name);
            let work = moving.contact_work();
            // in the mortared wall nothing is flagged: it looks for contacts and finds none
            let touches = match scene.maker {
                Maker::Plane(_) | Maker::Bridge => work.detections,
                Maker::Wall(_) => work.evaluated,
            };
            let dry = ["elastic", "jointed-nocontact", "wall-3d"].contains(&scene.name);
            assert_eq!(touches > 0, !dry, "{}", scene.name);
        }
    }

    #[test]
    fn debris_is_debris() {
        let scene = Scene::find("debris").expect("the scene");
        let mut simulation = simulation(&scene.deck(800, 100).expect("a deck"));
        for _ in 0..100 {
            simulation.evaluate_forces();
            simulation.advance();
        }
        let joints = (3 * 800 - 4 * 20) / 2;
        let broken = simulation.failures().len();
        assert!(broken > joints * 9 / 10, "{broken} of {joints} joints broke");
    }
}
