//! Contact detection in the plane: which triangles take part, and which pairs may become couples
//! (spec `y2d3d.md` E.2).

use super::{
    bonds::Bonds,
    couples::CoupleList,
    sweep::{Ball, Sweep, couple_or_part, distance_squared},
    visits::Kept,
};
use crate::{
    mechanics::Vec2,
    scene::{ContactSelection, Elements, Material, Nodes},
};

/// What detection looks at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Participants<'a> {
    /// Nodes with their current coordinates.
    pub nodes: &'a Nodes<2>,
    /// Materials, which say what kind an element is.
    pub materials: &'a [Material],
    /// Buffer around elements, m.
    pub buffer: f64,
    /// Which triangles take part.
    pub selection: ContactSelection,
    /// Joints that keep triangles from becoming couples.
    pub bonds: Option<Bonds<'a>>,
}

/// Detection with its buffers, reused from one time to the next.
#[derive(Debug, Clone, Default)]
pub(super) struct Detector {
    sweep: Sweep<2>,
}

impl Detector {
    /// Updates the couple list: pairs that come within the buffer are added,
    /// couples that left it are removed.
    pub fn update(
        &mut self,
        scene: &Participants<'_>,
        elements: &mut Elements,
        couples: &mut CoupleList<Kept>,
    ) {
        if scene.selection != ContactSelection::Flagged {
            tag_boundary_elements(scene, elements);
        }
        self.load(scene, elements);
        couples.resize(elements.len());
        self.sweep.pairs(scene.buffer, |a, b| examine(a, b, scene, elements, couples));
    }

    fn load(&mut self, scene: &Participants<'_>, elements: &Elements) {
        self.sweep.balls.clear();
        for element in 0..elements.len() {
            if !takes_part(scene, elements, element) {
                continue;
            }
            let tag = elements.contact_tag[element];
            if scene.selection.selects(tag, flags_of(scene, elements, element)) {
                let corners = elements.corners::<3>(element).map(|n| scene.nodes.current[n]);
                self.sweep.balls.push(circle_around(element as u32, tag, &corners));
            }
        }
    }
}

fn circle_around(element: u32, tag: i32, corners: &[Vec2; 3]) -> Ball<2> {
    let sum = corners[0] + corners[1] + corners[2];
    let centre = Vec2::new(sum.x / 3.0, sum.y / 3.0);
    let squared =
        corners.iter().fold(0.0, |r: f64, corner| r.max(distance_squared(&centre, corner)));
    Ball::new(element, tag, centre, squared.sqrt())
}

/// Adds or removes the couple of two elements as their distance asks.
fn examine(
    a: &Ball<2>,
    b: &Ball<2>,
    scene: &Participants<'_>,
    elements: &Elements,
    couples: &mut CoupleList<Kept>,
) {
    if scene.bonds.is_some_and(|bonds| bonds.exclude(elements, a.element, b.element)) {
        return;
    }
    if scene.selection == ContactSelection::Tagged && a.tag == b.tag {
        return;
    }
    if let Some(slot) = couple_or_part(a, b, scene.buffer, couples, CoupleList::find) {
        // the slot keeps the sliding of the couple that had it before, not its rest
        couples.kept_mut(slot).rest = 0.0;
    }
}

/// Gives every element with a node flagged 1 its own tag. Tags are never
/// taken back.
fn tag_boundary_elements(scene: &Participants<'_>, elements: &mut Elements) {
    for element in 0..elements.len() {
        if takes_part(scene, elements, element)
            && flags_of(scene, elements, element).any(|flag| flag == 1)
        {
            elements.contact_tag[element] = element as i32 + 1;
        }
    }
}

/// Flags of a triangle's corners.
fn flags_of(
    scene: &Participants<'_>,
    elements: &Elements,
    element: usize,
) -> impl Iterator<Item = i32> {
    elements.corners::<3>(element).into_iter().map(|n| scene.nodes.boundary_flag[n])
}

fn takes_part(scene: &Participants<'_>, elements: &Elements, element: usize) -> bool {
    usize::try_from(elements.property[element])
        .ok()
        .and_then(|property| scene.materials.get(property))
        .is_some_and(|material| material.kind.takes_part_in_contact())
}
