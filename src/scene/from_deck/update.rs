//! A scene changed by a later stage of its deck.

use super::{
    BuildOutcome, Profile, Reader, classic, contact, control, elements,
    geometry::Shapes,
    insertion, joints, load_history, materials, node_sets,
    nodes::{to_i32, vector},
    probes, unsupported,
};
use crate::scene::{Scene, SpatialContact};
use std::collections::BTreeSet;
use yformat::{database::Database, deck::Deck, diagnostic::Diagnostic};

/// The scene after a stage that names the keywords `named`: what is not named
/// stays as the run left it, and entities made by meshing keep their place.
#[must_use]
pub fn update_scene(
    deck: &Deck,
    database: &Database,
    scene: &Scene,
    named: &BTreeSet<String>,
    profile: Profile,
) -> BuildOutcome {
    updated(Reader::new(deck, database), scene, named, profile)
}

/// The same in three dimensions, with a law of contact that decks do not name.
#[must_use]
pub fn update_spatial_scene(
    deck: &Deck,
    database: &Database,
    scene: &Scene<3>,
    named: &BTreeSet<String>,
    profile: Profile,
    contact: SpatialContact,
) -> BuildOutcome<3> {
    updated(Reader::new(deck, database).with_contact(contact), scene, named, profile)
}

fn updated<const D: usize>(
    mut reader: Reader<'_>,
    scene: &Scene<D>,
    named: &BTreeSet<String>,
    profile: Profile,
) -> BuildOutcome<D>
where
    Scene<D>: Shapes,
{
    let scene = update(&mut reader, scene.clone(), named, profile);
    let findings = reader.into_findings();
    let failed = findings.iter().any(Diagnostic::is_error);
    BuildOutcome { scene: (!failed).then_some(scene), findings }
}

fn update<const D: usize>(
    reader: &mut Reader<'_>,
    mut scene: Scene<D>,
    named: &BTreeSet<String>,
    profile: Profile,
) -> Scene<D>
where
    Scene<D>: Shapes,
{
    unsupported::check(reader);
    check_counts(reader, &scene, named);
    update_settings(reader, &mut scene, named, profile);
    update_nodes(reader, &mut scene, named);
    update_elements(reader, &mut scene, named);
    if !reader.has_errors() {
        materials::check_use(reader, &scene);
        joints::check_use(reader, &scene);
        insertion::check_use(reader, &scene);
        node_sets::check_use(reader, &scene);
        scene.check_shapes(reader);
        scene.check_again(reader);
    }
    scene
}

/// Gives a scene the settings of a later stage, which a run has passed without errors before;
/// nodes and elements stay as they are.
pub fn replay_settings<const D: usize>(
    deck: &Deck,
    database: &Database,
    scene: &mut Scene<D>,
    named: &BTreeSet<String>,
    profile: Profile,
    contact: SpatialContact,
) {
    let mut reader = Reader::new(deck, database).with_contact(contact);
    update_settings(&mut reader, scene, named, profile);
}

/// Everything of a stage but nodes and elements.
fn update_settings<const D: usize>(
    reader: &mut Reader<'_>,
    scene: &mut Scene<D>,
    named: &BTreeSet<String>,
    profile: Profile,
) {
    // the classic dialect has one table for sets of all kinds
    let table = |name| if reader.is_classic() { "YDP" } else { name };
    let names = |database| named.iter().any(|n| n.split('/').next() == Some(database));
    let [materials_change, joints_change, nodes_change, meshing_changes] =
        ["YDPE", "YDPJ", "YDPN", "YDPM"].map(|database| names(table(database)));
    scene.control = control::read(reader, D);
    if reader.is_classic() {
        scene.ramp = Some(classic::ramp(reader));
    }
    if materials_change {
        let support_is_named = named.contains("YDPE/I1PSUP");
        let sets: Vec<i32> = scene.materials.iter().map(|m| m.joint_set).collect();
        scene.materials = materials::read(reader, D);
        for material in scene.materials.iter_mut().filter(|_| !support_is_named) {
            // it has been installed
            material.resets_shape = false;
        }
        // in the split dialect and Y-Geo the program itself says which joints there are
        if !reader.is_classic() && !named.contains("YDPE/I1PEJP") {
            for (material, set) in scene.materials.iter_mut().zip(sets) {
                material.joint_set = set;
            }
        }
    }
    if joints_change {
        scene.cohesive_laws = joints::read(reader, D);
        scene.joint_points = joints::points(reader, profile);
    }
    if nodes_change {
        scene.node_sets = node_sets::read(reader, profile);
        scene.load_history = load_history::read(reader, scene.node_sets.len());
    }
    if names("YDI") || named.contains("YDC/IWFAST") {
        scene.contact = contact::read(reader, D);
    }
    if meshing_changes {
        let earlier = scene.insertion.take();
        scene.insertion = insertion::read(reader, D, &scene.materials, profile);
        let codes = ["YDPM/I2PMSET", "YDP/I1PEMN", "YDP/I1PNFZ"];
        if !codes.iter().any(|code| named.contains(*code)) {
            // codes are consumed when they are executed
            match (&mut scene.insertion, earlier) {
                (Some(new), Some(old)) => new.combinations = old.combinations,
                (new, old) => *new = old,
            }
        }
    }
    if names("YDO") {
        update_probes(reader, scene);
    }
}

/// Restating the counts of a mesh that has grown would cut it.
fn check_counts<const D: usize>(
    reader: &mut Reader<'_>,
    scene: &Scene<D>,
    named: &BTreeSet<String>,
) {
    let mesh = [("YDN/NNOPO", scene.nodes.len()), ("YDE/NELEM", scene.elements.len())];
    // the sets of joints are numbered behind those of triangles
    let sets = reader.is_classic().then_some(("YDP/NPROP", scene.materials.len()));
    for (name, now) in mesh.into_iter().chain(sets) {
        if named.contains(name) && reader.integer(name) != now as i64 {
            reader.report(
                Diagnostic::error(
                    "scene::restated-count",
                    format!(
                        "a later stage sets {name} to {}, but there are {now}",
                        reader.integer(name)
                    ),
                )
                .at(reader.place(name))
                .expected(format!("{now}, or no {name} in this stage"))
                .help("meshing has changed the counts; leave them out of later stages"),
            );
        }
    }
}

fn update_probes<const D: usize>(reader: &mut Reader<'_>, scene: &mut Scene<D>) {
    let (probes, threshold) = probes::read(reader, D);
    if probes.len() != scene.probes.len() {
        reader.report(
            Diagnostic::error(
                "scene::restated-count",
                "a later stage changes the number of histories",
            )
            .at(reader.place("YDO/NOHYS"))
            .expected(format!("{} histories as in the first stage", scene.probes.len())),
        );
    }
    (scene.probes, scene.probe_threshold) = (probes, threshold);
}

fn update_nodes<const D: usize>(
    reader: &Reader<'_>,
    scene: &mut Scene<D>,
    named: &BTreeSet<String>,
) {
    let nodes = &mut scene.nodes;
    for (name, values) in [
        ("YDN/D2NCI", &mut nodes.initial),
        ("YDN/D2NCC", &mut nodes.current),
        ("YDN/D2NVC", &mut nodes.velocity),
    ] {
        if let Some(field) = reader.real_field(name).filter(|_| named.contains(name)) {
            for (n, value) in values.iter_mut().enumerate() {
                *value = vector(field, n);
            }
        }
    }
    for (name, values) in [("YDN/I1NOBF", &mut nodes.boundary_flag), ("YDN/I1NOPR", &mut nodes.set)]
    {
        replace(reader, name, values, named);
    }
}

fn update_elements<const D: usize>(
    reader: &mut Reader<'_>,
    scene: &mut Scene<D>,
    named: &BTreeSet<String>,
) {
    let elements = &mut scene.elements;
    if named.contains("YDE/I1ELPR") {
        replace(reader, "YDE/I1ELPR", &mut elements.property, named);
        if !reader.is_classic() {
            elements::name_joints(elements, reader.database.dialect(), D);
        }
        elements::check_properties(
            reader,
            D,
            elements.len(),
            |e| i64::from(elements.property[e]),
            |e| elements.nodes[e][D + 1] >= 0,
            scene.materials.len(),
            scene.cohesive_laws.len(),
        );
        if reader.is_classic() {
            classic::number_joints(elements, scene.materials.len());
        }
    }
    replace(reader, "YDE/I1ELBE", &mut elements.contact_tag, named);
    if let Some(field) = reader.real_field("YDE/D2ELST").filter(|_| named.contains("YDE/D2ELST")) {
        for (row, values) in elements.state.iter_mut().enumerate() {
            for (e, value) in values.iter_mut().enumerate() {
                *value = field.get2(row, e);
            }
        }
    }
}

fn replace(reader: &Reader<'_>, name: &str, values: &mut [i32], named: &BTreeSet<String>) {
    if let Some(field) = reader.integer_field(name).filter(|_| named.contains(name)) {
        for (i, value) in values.iter_mut().enumerate() {
            *value = to_i32(field.get1(i));
        }
    }
}
