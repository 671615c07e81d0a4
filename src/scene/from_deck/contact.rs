use super::{Reader, reader::Offenders, ygeo};
use crate::scene::{
    ContactSelection, ContactSettings, Conventions, ElementKind, FrictionModel, Insertion,
    PairRule, Scene,
};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

/// Sliding states that a couple needs: one for each edge of its two triangles.
const SLIDING_STATES: i64 = 6;

pub(super) fn read(reader: &mut Reader<'_>, dimension: usize) -> Option<ContactSettings> {
    if reader.integer("YDI/MICOUP") <= 0 {
        return None;
    }
    let states = reader.integer("YDI/MISTATE");
    if dimension == 2 && reader.knows("YDI/MISTATE") && states < SLIDING_STATES {
        reader.report(
            Diagnostic::warning(
                "scene::sliding-states",
                format!("MISTATE is {states}: the original writes beyond its arrays then"),
            )
            .at(reader.place("YDI/MISTATE").or_else(|| reader.word("YDI/MICOUP")))
            .expected("6, one for each edge of two triangles")
            .help("6 is used here; set /YD/YDI/MISTATE to 6 for the original"),
        );
    }
    let buffer = reader.real("YDI/DIEZON");
    if buffer < 0.0 {
        reader.report(
            Diagnostic::error(
                "scene::value-range",
                format!("the contact buffer DIEZON is {buffer}"),
            )
            .at(reader.place("YDI/DIEZON"))
            .expected("a length of 0 or more, about a fifth of the smallest element"),
        );
    }
    let sliding = reader.real_field("YDI/D2SLDIS").filter(|f| f.item().is_some());
    let slots = sliding.map_or(0, |f| f.given_shape().get(1).copied().unwrap_or(0));
    Some(ContactSettings {
        buffer,
        initial_travel: reader.real("YDI/DIEDI"),
        selection: match Conventions::of(reader.database.dialect()).selection {
            ContactSelection::Flagged => ContactSelection::Flagged,
            _ if reader.integer("YDC/IWFAST") == 0 => ContactSelection::All,
            _ => ContactSelection::Tagged,
        },
        pairs: pair_rule(reader),
        friction: friction_model(reader),
        initial_sliding: (0..slots)
            .map(|slot| std::array::from_fn(|k| sliding.map_or(0.0, |f| f.get2(k, slot))))
            .collect(),
        spatial: reader.spatial_contact,
    })
}

fn friction_model(reader: &mut Reader<'_>) -> FrictionModel {
    match reader.integer("YDC/ICFMTY") {
        0 => FrictionModel::Coulomb,
        1 => FrictionModel::BartonBandis,
        other => {
            reader.report(
                Diagnostic::error(
                    "scene::value-range",
                    format!("ICFMTY is {other}, which is no model of friction"),
                )
                .at(reader.place("YDC/ICFMTY"))
                .expected("0 (Coulomb) or 1 (Barton and Bandis)"),
            );
            FrictionModel::Coulomb
        }
    }
}

fn pair_rule(reader: &mut Reader<'_>) -> PairRule {
    match reader.database.dialect() {
        Dialect::YGeo => ygeo::pair_table(reader),
        Dialect::Classic => PairRule::InterfaceFriction,
        _ => PairRule::SmallerOfEach,
    }
}

/// Checks that need the whole scene.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let Some(contact) = &scene.contact else { return };
    let touches = |e: usize| scene.material_of(e).is_some_and(|m| m.kind.takes_part_in_contact());
    let tagged = |e: usize| {
        let counts = |flag: i32| match contact.selection {
            ContactSelection::Flagged => flag > 0,
            _ => flag == 1,
        };
        let flagged = |n: usize| counts(scene.nodes.boundary_flag[n]);
        scene.elements.contact_tag[e] > 0
            || scene.elements.nodes[e][..=D].iter().any(|&n| flagged(n as usize))
    };
    let candidates = (0..scene.elements.len()).filter(|&e| touches(e)).count();
    let part = (0..scene.elements.len()).filter(|&e| touches(e) && tagged(e)).count();
    // joint insertion and refinement flag nodes themselves
    let flags_nodes = scene.insertion.as_ref().is_some_and(Insertion::changes_mesh);
    if candidates > 1 && part == 0 && contact.selection != ContactSelection::All && !flags_nodes {
        reader.report(
            Diagnostic::warning(
                "scene::no-contact",
                "no element takes part in contact: no node is flagged as boundary",
            )
            .at(reader.word("YDN/I1NOBF").or_else(|| reader.word("YDI/MICOUP")))
            .expected(if reader.knows("YDC/IWFAST") {
                "1 in I1NOBF for boundary nodes, or IWFAST 0 to let all elements take part"
            } else {
                "1 in I1NOBF for boundary nodes"
            }),
        );
    }
    if contact.initial_travel < contact.buffer {
        reader.report(
            Diagnostic::warning(
                "scene::late-detection",
                format!(
                    "DIEDI {} is below DIEZON {}: contact is not looked for until nodes have travelled {}",
                    contact.initial_travel,
                    contact.buffer,
                    contact.buffer - contact.initial_travel
                ),
            )
            .at(reader.place("YDI/DIEDI"))
            .expected("a large number such as 200, which makes the first step look for contact"),
        );
    }
    match contact.pairs {
        PairRule::SmallerOfEach => {
            check_penalties(reader, scene);
            if D == 2 || contact.spatial.has_friction {
                check_tangential_penalties(reader, scene);
            } else {
                check_friction(reader, scene);
            }
        }
        PairRule::InterfaceFriction => check_penalties(reader, scene),
        PairRule::Table(_) => {}
    }
}

fn check_penalties<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let used = |set: usize| scene.elements.property.contains(&(set as i32));
    let sets = scene.materials.len();
    let missing = |set: usize| {
        let m = &scene.materials[set];
        m.kind.takes_part_in_contact() && used(set) && m.contact_penalty == 0.0
    };
    if let Some(found) = Offenders::find(sets, missing) {
        reader.report(
            Diagnostic::warning(
                "scene::no-contact",
                format!(
                    "material {} has no contact penalty: its elements touch without force{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry("YDPE/D1PEPE", found.first).or_else(|| reader.word("YDPE/NPROP")))
            .expected(format!(
                "a penalty of 10 to 100 times the elastic modulus in /YD/{}",
                reader.called("YDPE/D1PEPE")
            )),
        );
    }
}

/// In 3D contact has no friction.
fn check_friction<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let frictional = |set: usize| scene.materials[set].friction != 0.0;
    if let Some(found) = Offenders::find(scene.materials.len(), frictional) {
        reader.report(
            Diagnostic::warning(
                "scene::no-effect",
                format!(
                    "the friction of material {} has no effect: contact is frictionless in 3D{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry("YDPE/D1PEFR", found.first))
            .expected("0, as in the original bodies slide freely on each other in 3D")
            .help("`ypsilon run --contact-friction` lets friction act"),
        );
    }
}

fn check_tangential_penalties<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let used = |set: usize| scene.elements.property.contains(&(set as i32));
    let sets = scene.materials.len();
    let frictional = |set: usize| {
        let m = &scene.materials[set];
        m.kind != ElementKind::SofteningTriangle
            && used(set)
            && m.friction > 0.0
            && m.tangential_penalty == 0.0
    };
    if let Some(found) = Offenders::find(sets, frictional) {
        reader.report(
            Diagnostic::error(
                "scene::tangential-penalty",
                format!(
                    "material {} has friction, but no tangential penalty{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader
                .entry("YDPE/D1PEPT", found.first)
                .or_else(|| reader.entry("YDPE/D1PEFR", found.first)))
            .expected(
                "a tangential penalty in /YD/YDPE/D1PEPT, about a tenth of the contact penalty",
            )
            .help("the original cannot run without D1PEPT"),
        );
    }
}
