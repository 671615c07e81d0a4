use super::{Slip, Vec3, pair_index::PairIndex, surfaces::Surfaces};
use crate::{
    contact::{
        couples::CoupleList,
        sweep::{Ball, Sweep, couple_or_part, distance_squared},
    },
    scene::{ContactSelection, Elements, JointKind},
};
use std::collections::HashSet;

/// What detection looks at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Participants<'a> {
    pub elements: &'a Elements,
    pub positions: &'a [Vec3],
    pub boundary_flags: &'a [i32],
    pub surfaces: &'a Surfaces,
    /// Buffer around elements, m.
    pub buffer: f64,
    pub selection: ContactSelection,
}

impl Participants<'_> {
    fn takes_part(&self, element: usize) -> bool {
        self.surfaces.touches(self.elements.property[element])
    }

    /// Flags of the element's nodes.
    fn flags_of(&self, element: usize) -> impl Iterator<Item = i32> {
        self.elements.corners::<4>(element).into_iter().map(|node| self.boundary_flags[node])
    }

    /// Gives every element with a node flagged 1 its own tag. Tags are never taken back.
    pub fn tag_boundary_elements(&self, tags: &mut [i32]) {
        if matches!(self.selection, ContactSelection::Flagged | ContactSelection::Bodies) {
            return;
        }
        for (element, tag) in tags.iter_mut().enumerate() {
            if self.takes_part(element) && self.flags_of(element).any(|flag| flag == 1) {
                *tag = element as i32 + 1;
            }
        }
    }
}

/// Detection with its buffers, reused from one time to the next.
#[derive(Debug, Clone, Default)]
pub(super) struct Detector {
    sweep: Sweep<3>,
    index: PairIndex,
    fractures: Fractures,
}

/// Which elements of one body may touch (spec `y3d.md` 3.1): those that a joint has let go, unless
/// another joint holds them together.
#[derive(Debug, Clone, Default)]
struct Fractures {
    /// Elements at a broken joint; empty where none has broken.
    let_go: Vec<bool>,
    bonded: HashSet<[u32; 2]>,
}

impl Fractures {
    fn find(&mut self, elements: &Elements) {
        self.let_go.clear();
        self.bonded.clear();
        if !elements.joint_kind.contains(&JointKind::Broken) {
            return;
        }
        self.let_go.resize(elements.len(), false);
        for (kind, sides) in elements.joint_kind.iter().zip(&elements.sides) {
            let Ok(first) = u32::try_from(sides[0]) else { continue };
            let Ok(second) = u32::try_from(sides[1]) else { continue };
            match kind {
                JointKind::Broken => {
                    self.let_go[first as usize] = true;
                    self.let_go[second as usize] = true;
                }
                JointKind::Intact => {
                    self.bonded.insert([first.min(second), first.max(second)]);
                }
                _ => {}
            }
        }
    }

    fn may_touch(&self, a: u32, b: u32) -> bool {
        let is_let_go = |e: u32| self.let_go.get(e as usize).is_some_and(|&let_go| let_go);
        is_let_go(a) && is_let_go(b) && !self.bonded.contains(&[a.min(b), a.max(b)])
    }
}

/// Updates the couple list: pairs that come within the buffer are added, couples that left it and
/// lie in neighbouring cells are removed.
pub(super) fn update(
    Detector { sweep, index, fractures }: &mut Detector,
    scene: &Participants<'_>,
    tags: &[i32],
    couples: &mut CoupleList<Slip>,
) {
    sweep.balls.clear();
    sweep.first_idle = None;
    for (element, &tag) in tags.iter().enumerate() {
        let is_selected =
            scene.takes_part(element) && scene.selection.selects(tag, scene.flags_of(element));
        if is_selected {
            let corners = scene.elements.corners::<4>(element).map(|n| scene.positions[n]);
            sweep.balls.push(ball_around(element as u32, tag, &corners));
        } else {
            sweep.first_idle.get_or_insert(element as u32);
        }
    }
    if scene.selection == ContactSelection::Bodies {
        fractures.find(scene.elements);
    }
    couples.resize(tags.len());
    index.fill(couples);
    let find = |_: &CoupleList<Slip>, contactor, target| index.find(contactor, target);
    sweep.pairs(scene.buffer, |a, b| {
        let may_touch = match scene.selection {
            ContactSelection::All | ContactSelection::Flagged => true,
            ContactSelection::Tagged => a.tag != b.tag,
            ContactSelection::Bodies => a.tag != b.tag || fractures.may_touch(a.element, b.element),
        };
        if may_touch {
            couple_or_part(a, b, scene.buffer, couples, find);
        }
    });
}

fn ball_around(element: u32, tag: i32, corners: &[Vec3; 4]) -> Ball<3> {
    let centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0;
    let squared =
        corners.iter().fold(0.0, |r: f64, corner| r.max(distance_squared(&centre, corner)));
    Ball::new(element, tag, centre, squared.sqrt())
}
