use super::Reader;
use crate::scene::{
    ContactSelection, ContactSettings, Conventions, FrictionModel, Material, PairRule,
    PressedFaces, Scene, SpatialContact, from_deck::reader::Offenders,
};
use yformat::diagnostic::Diagnostic;

/// Contact, with both integrals of the force (spec `y3d.md` 3.2) and friction where a material
/// has it.
pub(super) fn read(reader: &mut Reader<'_>, materials: &[Material]) -> Option<ContactSettings> {
    if reader.integer("YDI/MICOUP") <= 0 {
        return None;
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
    Some(ContactSettings {
        buffer,
        initial_travel: reader.real("YDI/DIEDI"),
        selection: match reader.integer("YDC/IWFAST") {
            0 => ContactSelection::All,
            _ => Conventions::Y3D.selection,
        },
        pairs: PairRule::SmallerOfEach,
        friction: FrictionModel::Coulomb,
        initial_sliding: Vec::new(),
        spatial: SpatialContact {
            pressed: PressedFaces::Both,
            has_friction: materials.iter().any(|m| m.friction > 0.0),
        },
    })
}

/// Checks that need the whole scene.
pub(super) fn check_use(reader: &mut Reader<'_>, scene: &Scene<3>) {
    let Some(contact) = &scene.contact else { return };
    let elements = &scene.elements;
    let tags = &elements.contact_tag;
    let part = tags.iter().filter(|&&tag| tag > 0).count();
    if elements.len() > 1 && part == 0 && contact.selection == ContactSelection::Bodies {
        reader.report(
            Diagnostic::warning(
                "scene::no-contact",
                "no element takes part in contact: none has a body number",
            )
            .at(reader.word("YDE/I1ELBE").or_else(|| reader.word("YDI/MICOUP")))
            .expected("body numbers above 0 in I1ELBE for elements with a surface node, or IWFAST 0 to let all elements take part"),
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
    let several = tags.iter().any(|&tag| tag > 0 && Some(&tag) != tags.iter().find(|&&t| t > 0));
    let untouched = |set: usize| {
        elements.property.contains(&(set as i32)) && scene.materials[set].contact_penalty == 0.0
    };
    if let Some(found) = Offenders::find(scene.materials.len(), untouched).filter(|_| several) {
        reader.report(
            Diagnostic::warning(
                "scene::no-contact",
                format!(
                    "material {} has no contact penalty: its elements touch without force{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry("YDP/D1PEPE", found.first).or_else(|| reader.word("YDP/NPROP")))
            .expected("a penalty of 10 to 100 times the elastic modulus in /YD/YDP/D1PEPE"),
        );
    }
}
