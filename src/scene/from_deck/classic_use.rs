//! Checks of classic decks that need the whole scene.

use super::{Reader, classic::JOINT_TYPE, insertion, reader::Offenders};
use crate::scene::{ElementKind, Insertion, JointKind, Scene};
use yformat::diagnostic::Diagnostic;

/// Codes of the original for the types that move.
const TRIANGLE_TYPES: [i64; 2] = [1, 2];
const NODE_TYPE: i64 = -1;

/// Joint state that a restart reads, beside the number of joints.
const JOINT_STATE: [&str; 19] = [
    "YDJ/D1JKNI",
    "YDJ/D1JKNC",
    "YDJ/D1JKSC",
    "YDJ/D1JNST",
    "YDJ/D1JSST",
    "YDJ/D1JAPI",
    "YDJ/D1JAPC",
    "YDJ/D1JAPH",
    "YDJ/D1JAPR",
    "YDJ/D1JSDC",
    "YDJ/D1JDLC",
    "YDJ/D1JSDP",
    "YDJ/D1JEFL",
    "YDJ/D1JJRC",
    "YDJ/D1JJCS",
    "YDJ/D1JPHI",
    "YDJ/D1JFMD",
    "YDJ/D1JFPR",
    "YDJ/D1JFET",
];

/// Reports what the common property table and its users make of each other.
pub(super) fn check(reader: &mut Reader<'_>, scene: &Scene) {
    check_again(reader, scene);
    check_mesh_codes(reader, scene);
    check_restart(reader, scene);
    check_contact(reader, scene);
}

/// The same for later stages, which go on with what the first one has set up.
pub(super) fn check_again(reader: &mut Reader<'_>, scene: &Scene) {
    check_triangles(reader, scene);
    check_nodes(reader, scene);
    check_joint_sets(reader, scene);
}

fn type_of(reader: &Reader<'_>, set: usize) -> i64 {
    reader.integers("YDP/I1PTYP", -1)(set)
}

fn name_of(code: i64) -> String {
    match code {
        NODE_TYPE => "-1 (nodes)".to_owned(),
        1 => "1 (elastic triangles)".to_owned(),
        2 => "2 (rigid triangles)".to_owned(),
        JOINT_TYPE => "3 (joints)".to_owned(),
        other => other.to_string(),
    }
}

/// Numbers of the sets of some types, for messages.
fn sets_of(reader: &Reader<'_>, types: &[i64], sets: usize) -> String {
    let named: Vec<String> = (0..sets)
        .filter(|&set| types.contains(&type_of(reader, set)))
        .take(20)
        .map(|set| set.to_string())
        .collect();
    if named.is_empty() { "there is none".to_owned() } else { named.join(", ") }
}

/// Triangles of a set that is not of triangles.
fn check_triangles(reader: &mut Reader<'_>, scene: &Scene) {
    let elements = &scene.elements;
    let inert = |e: usize| {
        elements.joint_kind[e] == JointKind::NoJoint
            && scene.material_of(e).is_some_and(|m| matches!(m.kind, ElementKind::Inert(_)))
    };
    let Some(found) = Offenders::find(elements.len(), inert) else { return };
    let set = usize::try_from(elements.property[found.first]).unwrap_or(0);
    reader.report(
        Diagnostic::warning(
            "scene::element-type",
            format!(
                "element {} has property set {set} of type {}: it has neither stiffness nor mass{}",
                found.first,
                name_of(type_of(reader, set)),
                found.more()
            ),
        )
        .at(reader.entry("YDE/I1ELPR", found.first))
        .expected(format!(
            "a property set of type 1 (elastic) or 2 (rigid): {}",
            sets_of(reader, &TRIANGLE_TYPES, scene.materials.len())
        )),
    );
}

/// Nodes of a set that is not of nodes. Rigid triangles move theirs all the same.
fn check_nodes(reader: &mut Reader<'_>, scene: &Scene) {
    let mut carried = vec![false; scene.nodes.len()];
    for e in 0..scene.elements.len() {
        if scene.material_of(e).is_some_and(|m| m.kind == ElementKind::RigidTriangle) {
            for node in scene.elements.corners::<3>(e) {
                carried[node] = true;
            }
        }
    }
    let still = |node: usize| {
        let set = usize::try_from(scene.nodes.set[node]).ok();
        !carried[node] && set.and_then(|s| scene.node_sets.get(s)).is_some_and(|s| !s.moves)
    };
    let Some(found) = Offenders::find(scene.nodes.len(), still) else { return };
    let set = usize::try_from(scene.nodes.set[found.first]).unwrap_or(0);
    reader.report(
        Diagnostic::warning(
            "scene::node-set",
            format!(
                "node {} belongs to property set {set} of type {}: it never moves{}",
                found.first,
                name_of(type_of(reader, set)),
                found.more()
            ),
        )
        .at(reader.entry("YDN/I1NOPR", found.first))
        .expected(format!(
            "a property set of type -1 (nodes): {}",
            sets_of(reader, &[NODE_TYPE], scene.node_sets.len())
        )),
    );
}

/// Meshing codes of sets that are not of triangles, and digits without meaning.
fn check_mesh_codes(reader: &mut Reader<'_>, scene: &Scene) {
    let code = reader.integers("YDP/I1PEMN", -1);
    for (set, material) in scene.materials.iter().enumerate().filter(|(set, _)| code(*set) > 0) {
        let place = reader.entry("YDP/I1PEMN", set);
        if material.kind.takes_part_in_contact() {
            insertion::check_digits(reader, code(set), place);
            check_separation(reader, set, code(set));
            continue;
        }
        reader.report(
            Diagnostic::warning(
                "scene::mesh-code",
                format!(
                    "mesh code {} of property set {set} does nothing: the set has type {}",
                    code(set),
                    name_of(type_of(reader, set))
                ),
            )
            .at(place)
            .expected("0 for sets of other types than 1 and 2"),
        );
    }
}

/// Triangles without joints on their edges make the original read before its arrays.
fn check_separation(reader: &mut Reader<'_>, set: usize, code: i64) {
    let digits = code.to_string();
    if digits.contains('4') && !digits.contains('3') {
        reader.report(
            Diagnostic::note(
                "scene::original-needs",
                format!("mesh code {code} separates triangles without joints: the original may crash at their first contact"),
            )
            .at(reader.entry("YDP/I1PEMN", set))
            .help("for the original let digit 3 follow to the left, as in 34"),
        );
    }
}

fn has_joints(scene: &Scene) -> bool {
    let live = |kind: &JointKind| !matches!(kind, JointKind::NoJoint | JointKind::FreeEdge);
    scene.insertion.as_ref().is_some_and(Insertion::inserts_joints)
        || scene.elements.joint_kind.iter().any(live)
}

/// All joint sets act on all joints.
fn check_joint_sets(reader: &mut Reader<'_>, scene: &Scene) {
    let laws: Vec<usize> =
        (0..scene.cohesive_laws.len()).filter(|&s| scene.cohesive_laws[s].is_cohesive).collect();
    if laws.len() < 2 || !has_joints(scene) {
        return;
    }
    reader.report(
        Diagnostic::warning(
            "scene::joint-sets",
            format!(
                "{} property sets have type 3 (joints): each of them acts on every joint",
                laws.len()
            ),
        )
        .at(reader.entry("YDP/I1PTYP", laws[1]))
        .label(format!("besides set {}", laws[0]))
        .expected("one set of type 3 for all joints")
        .help("as in the original the forces of all joint sets add up, whatever I1PEJP names and even if no joint has the set"),
    );
}

/// Starting later than at step 0 needs the state of the joints.
fn check_restart(reader: &mut Reader<'_>, scene: &Scene) {
    if reader.integer("YDC/NCSTEP") <= 0 || !has_joints(scene) {
        return;
    }
    let joints = scene.elements.joint_kind.iter().filter(|k| **k != JointKind::NoJoint).count();
    let given = reader.integer("YDJ/NJOINT");
    let help = "give the database YDJ of a restart deck, or begin with /YD/YDC/NCSTEP 0";
    if scene.insertion.as_ref().is_some_and(Insertion::inserts_joints) {
        reader.report(
            Diagnostic::error(
                "scene::joint-restart",
                "joints are to be inserted, but they are set up at step 0 only",
            )
            .at(reader.place("YDC/NCSTEP"))
            .expected("NCSTEP 0")
            .help(help),
        );
    } else if given != joints as i64 {
        reader.report(
            Diagnostic::error(
                "scene::joint-restart",
                format!("NJOINT is {given}, but the run goes on with joints: {joints}"),
            )
            .at(reader.place("YDJ/NJOINT").or_else(|| reader.place("YDC/NCSTEP")))
            .expected("the state of all joints in database YDJ")
            .help(help),
        );
    } else {
        for name in JOINT_STATE {
            let _ = reader.required_reals(name, "joints", joints);
        }
    }
}

fn check_contact(reader: &mut Reader<'_>, scene: &Scene) {
    if scene.contact.is_none() {
        reader.report(
            Diagnostic::note(
                "scene::original-needs",
                "the original cannot run a deck without room for contact couples (MICOUP)",
            )
            .at(reader.place("YDI/MICOUP"))
            .help("there is no contact here; for the original give /YD/YDI/MICOUP and no node flagged as boundary"),
        );
    }
}
