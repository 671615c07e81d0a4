//! From a deck's values to a [`Scene`], with every check on the way.
//!
//! Where the original accepts a deck with a determinate result, so does this;
//! where it crashes, reads beyond its arrays or silently computes nonsense,
//! there is an error that says where and how to mend it. One pass reports all
//! findings.

mod classic;
mod classic_use;
mod contact;
mod control;
mod elements;
mod geometry;
mod insertion;
mod joints;
mod load_history;
mod materials;
mod names;
mod node_sets;
mod nodes;
mod probes;
mod reader;
mod solids;
mod unsupported;
mod update;
mod y3d;
mod ygeo;

pub use update::{replay_settings, update_scene, update_spatial_scene};

use super::{Conventions, Scene, SpatialContact};
use geometry::Shapes;
use reader::Reader;
use serde::{Deserialize, Serialize};
use yformat::{database::Database, deck::Deck, diagnostic::Diagnostic, dialect::Dialect};

/// Which of the two programs of the split dialect is followed where they differ
/// (spec `y2d3d.md` L).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Profile {
    /// The Windows program: no normalisation of local axes.
    #[default]
    Windows,
    /// The published source: local axes are normalised, joints between tetrahedra open contact where they fail
    Source,
}

/// A scene, if the deck has no errors, and all findings.
#[derive(Debug)]
pub struct BuildOutcome<const D: usize = 2> {
    /// The scene; `None` if there is an error among the findings.
    pub scene: Option<Scene<D>>,
    /// Errors, warnings and notes in the order of the checks.
    pub findings: Vec<Diagnostic>,
}

/// Builds the scene that the items of `deck` applied to `database` describe.
/// `name` is the base name of the output files.
#[must_use]
pub fn from_deck(deck: &Deck, database: &Database, name: &str, profile: Profile) -> BuildOutcome {
    outcome(Reader::new(deck, database), name, profile)
}

/// The same for a deck in three dimensions, with a law of contact that decks do not name.
#[must_use]
pub fn spatial_from_deck(
    deck: &Deck,
    database: &Database,
    name: &str,
    profile: Profile,
    contact: SpatialContact,
) -> BuildOutcome<3> {
    if database.dialect() == Dialect::Y3d {
        let mut reader = Reader::new(deck, database);
        let scene = y3d::build(&mut reader, name);
        return finished(reader, scene);
    }
    outcome(Reader::new(deck, database).with_contact(contact), name, profile)
}

fn outcome<const D: usize>(mut reader: Reader<'_>, name: &str, profile: Profile) -> BuildOutcome<D>
where
    Scene<D>: Shapes,
{
    let scene = build(&mut reader, name, profile);
    finished(reader, scene)
}

fn finished<const D: usize>(reader: Reader<'_>, scene: Option<Scene<D>>) -> BuildOutcome<D> {
    let findings = reader.into_findings();
    let failed = findings.iter().any(Diagnostic::is_error);
    BuildOutcome { scene: scene.filter(|_| !failed), findings }
}

fn build<const D: usize>(reader: &mut Reader<'_>, name: &str, profile: Profile) -> Option<Scene<D>>
where
    Scene<D>: Shapes,
{
    unsupported::check(reader);
    let conventions = Conventions::of(reader.database.dialect());
    let control = control::read(reader, D);
    let nodes = nodes::read(reader)?;
    let node_count = nodes.len();
    let materials = materials::read(reader, D);
    let cohesive_laws = joints::read(reader, D);
    let is_classic = conventions.dialect == Dialect::Classic;
    let mut elements =
        elements::read(reader, D, nodes.len(), materials.len(), cohesive_laws.len())?;
    if is_classic {
        classic::name_joints(reader, &mut elements, materials.len());
    }
    let element_count = elements.len();
    let node_sets = node_sets::read(reader, profile);
    let load_history = load_history::read(reader, node_sets.len());
    let contact = contact::read(reader, D);
    let insertion = insertion::read(reader, D, &materials, profile);
    let (probes, probe_threshold) = probes::read(reader, D);
    let scene = Scene {
        name: name.to_owned(),
        conventions,
        control,
        nodes,
        elements,
        materials,
        cohesive_laws,
        node_sets,
        load_history,
        ramp: is_classic.then(|| classic::ramp(reader)),
        initial_aperture: classic::initial_aperture(reader),
        joint_restart: classic::joint_restart(reader, element_count),
        snapshots: is_classic.then(|| classic::snapshots(reader)),
        in_situ: ygeo::in_situ(reader),
        fracture_network: ygeo::fracture_network(reader, node_count),
        seismic: ygeo::seismic(reader),
        joint_points: joints::points(reader, profile),
        failed_joints: joints::failed(D, profile),
        hysteretic_joints: reader.integer("YDPJ/IUSEHY") != 0,
        face_pressures: Vec::new(),
        pressure_ramp: 0.0,
        contact,
        insertion,
        probes,
        probe_threshold,
    };
    if !reader.has_errors() {
        materials::check_use(reader, &scene);
        joints::check_use(reader, &scene);
        insertion::check_use(reader, &scene);
        scene.check_shapes(reader);
        node_sets::check_use(reader, &scene);
        contact::check_use(reader, &scene);
        scene.check_places(reader);
    }
    Some(scene)
}
