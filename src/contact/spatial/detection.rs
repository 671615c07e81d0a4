use super::{Slip, Vec3, pair_index::PairIndex, surfaces::Surfaces};
use crate::{
    contact::{
        couples::CoupleList,
        sweep::{Ball, Sweep, couple_or_part, distance_squared},
    },
    scene::{ContactSelection, Elements},
};

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

    /// Whether a node of the element has a flag that `counts`.
    fn is_flagged(&self, element: usize, counts: impl Fn(i32) -> bool) -> bool {
        let nodes = self.elements.corners::<4>(element);
        nodes.into_iter().any(|node| counts(self.boundary_flags[node]))
    }

    /// Gives every element with a node flagged 1 its own tag. Tags are never taken back.
    pub fn tag_boundary_elements(&self, tags: &mut [i32]) {
        if self.selection == ContactSelection::Flagged {
            return;
        }
        for (element, tag) in tags.iter_mut().enumerate() {
            if self.takes_part(element) && self.is_flagged(element, |flag| flag == 1) {
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
}

/// Updates the couple list: pairs that come within the buffer are added, couples that left it and
/// lie in neighbouring cells are removed.
pub(super) fn update(
    Detector { sweep, index }: &mut Detector,
    scene: &Participants<'_>,
    tags: &[i32],
    couples: &mut CoupleList<Slip>,
) {
    sweep.balls.clear();
    sweep.first_idle = None;
    for (element, &tag) in tags.iter().enumerate() {
        let is_selected = scene.takes_part(element)
            && match scene.selection {
                ContactSelection::All => true,
                ContactSelection::Tagged => tag > 0,
                ContactSelection::Flagged => scene.is_flagged(element, |flag| flag > 0),
            };
        if is_selected {
            let corners = scene.elements.corners::<4>(element).map(|n| scene.positions[n]);
            sweep.balls.push(ball_around(element as u32, tag, &corners));
        } else {
            sweep.first_idle.get_or_insert(element as u32);
        }
    }
    couples.resize(tags.len());
    index.fill(couples);
    let find = |_: &CoupleList<Slip>, contactor, target| index.find(contactor, target);
    sweep.pairs(scene.buffer, |a, b| {
        if scene.selection != ContactSelection::Tagged || a.tag != b.tag {
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
