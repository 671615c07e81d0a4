//! Which old fractures hang together, and the apertures that they begin with
//! (classic, spec `mechanics.md` 7.10.1).
//!
//! Joints that meet two by two form a section; sections that go on straight
//! beyond an intersection form a line. (The original leaves fractures without a
//! free end unset, and their state is no number; here they are set up like all
//! others.)

use crate::{
    TOLERANCE,
    mechanics::{Vec2, aperture::Aperture},
    scene::{JointKind, Scene},
};

/// Cosine of the angle within which sections go on straight.
const STRAIGHT: f64 = 0.99;

/// Apertures of the elements from `first_joint` on.
pub(super) fn initial_apertures(scene: &Scene, first_joint: usize) -> Vec<Aperture> {
    let fractures = Fractures::new(scene);
    let mut lengths = vec![(0.0, 0.0); scene.elements.len()];
    for (index, &element) in fractures.joints.iter().enumerate() {
        lengths[element] = (fractures.section_length(index), fractures.line_length(index));
    }
    (first_joint..scene.elements.len())
        .map(|element| {
            let set = scene.elements.property[element] - scene.materials.len() as i32;
            let law = usize::try_from(set).ok().and_then(|s| scene.cohesive_laws.get(s));
            let Some(law) = law else { return Aperture::default() };
            let (section, line) = lengths[element];
            match scene.elements.joint_kind[element] {
                JointKind::Intact | JointKind::Broken => Aperture::intact(&law.rock),
                JointKind::PreExisting => Aperture::of_fracture(
                    &law.rock,
                    scene.initial_aperture,
                    law.fracture_energy,
                    section,
                    line,
                ),
                JointKind::FreeEdge | JointKind::NoJoint => Aperture::default(),
            }
        })
        .collect()
}

/// Groups of things that belong together.
struct Groups(Vec<usize>);

impl Groups {
    fn new(len: usize) -> Self {
        Self((0..len).collect())
    }

    fn root(&self, mut i: usize) -> usize {
        while self.0[i] != i {
            i = self.0[i];
        }
        i
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b)] = a.min(b);
    }
}

struct Fractures {
    /// Elements.
    joints: Vec<usize>,
    lengths: Vec<f64>,
    sections: Groups,
    lines: Groups,
}

/// An end of a joint.
#[derive(Clone, Copy)]
struct End {
    joint: usize,
    place: Vec2,
    /// Direction of the joint from this end on.
    direction: Vec2,
}

impl Fractures {
    fn new(scene: &Scene) -> Self {
        let elements = &scene.elements;
        let joints: Vec<usize> = (0..elements.len())
            .filter(|&e| elements.joint_kind[e] == JointKind::PreExisting)
            .collect();
        let mut ends = Vec::with_capacity(2 * joints.len());
        let mut lengths = Vec::with_capacity(joints.len());
        for (joint, &element) in joints.iter().enumerate() {
            let [a, b] = elements.corners::<2>(element).map(|n| scene.nodes.initial[n]);
            lengths.push((b - a).norm());
            ends.push(End { joint, place: a, direction: (b - a).normalize() });
            ends.push(End { joint, place: b, direction: (a - b).normalize() });
        }
        let mut sections = Groups::new(joints.len());
        let meetings = meetings(ends);
        for meeting in meetings.iter().filter(|m| m.len() == 2) {
            sections.join(meeting[0].joint, meeting[1].joint);
        }
        let mut lines = Groups(sections.0.clone());
        for meeting in &meetings {
            for (i, a) in meeting.iter().enumerate() {
                for b in &meeting[i + 1..] {
                    if a.direction.dot(&b.direction) <= -STRAIGHT {
                        lines.join(a.joint, b.joint);
                    }
                }
            }
        }
        Self { joints, lengths, sections, lines }
    }

    fn section_length(&self, joint: usize) -> f64 {
        self.sum(&self.sections, joint)
    }

    fn line_length(&self, joint: usize) -> f64 {
        self.sum(&self.lines, joint)
    }

    fn sum(&self, groups: &Groups, joint: usize) -> f64 {
        let root = groups.root(joint);
        let members = (0..self.joints.len()).filter(|&j| groups.root(j) == root);
        members.map(|j| self.lengths[j]).sum()
    }
}

/// Ends that lie at the same place.
fn meetings(mut ends: Vec<End>) -> Vec<Vec<End>> {
    ends.sort_by(|a, b| a.place.x.total_cmp(&b.place.x));
    let mut found: Vec<Vec<End>> = Vec::new();
    for end in ends {
        let near = |m: &&mut Vec<End>| {
            let d = m[0].place - end.place;
            d.x.abs() < TOLERANCE && d.y.abs() < TOLERANCE
        };
        let candidates = found.iter_mut().rev();
        let mut close = candidates.take_while(|m| end.place.x - m[0].place.x < TOLERANCE);
        match close.find(near) {
            Some(meeting) => meeting.push(end),
            None => found.push(vec![end]),
        }
    }
    found
}
