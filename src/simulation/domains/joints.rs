//! Live joints of a domain, four at a time (split dialect).

use super::{
    super::plan::{Plan, PlannedJoint},
    FailedJoint, Step,
    owners::Owners,
    triangles::gather,
};
use crate::{
    lanes::{self, Kernel, LANES, Lanes, Pair as _},
    mechanics::{
        Vec2,
        joint2::{
            self, SplitRules,
            intact::{self, LawLanes},
        },
    },
    scene::{CohesiveLaw, Scene},
};

/// All nodes of all lanes.
const ALL: u16 = u16::MAX;

/// Four joints of one law that follow each other; lanes without live joint have no effect.
#[derive(Debug, Clone)]
#[repr(align(32))]
pub(super) struct JointBlock {
    /// Shear strengths, Pa: the domain's own copy of the simulation's.
    strength: [f64; LANES],
    /// Nodes a, b, c, d.
    corners: [[u32; LANES]; 4],
    elements: [u32; LANES],
    /// The largest node among the corners and the largest of the elements.
    largest_node: u32,
    largest_element: u32,
    /// Bit `4 * lane + i`: the domain owns node `i`.
    owned: u16,
    /// Lanes with live joints.
    live: u8,
    /// Lanes whose strength and failure this domain reports.
    reports: u8,
    /// Whether all nodes are owned and those of a joint differ.
    is_plain: bool,
}

/// A joint in a lane.
#[derive(Debug, Clone, Copy)]
struct Lane {
    strength: f64,
    corners: [u32; 4],
    element: u32,
    owned: u16,
    reports: bool,
}

impl JointBlock {
    /// Blocks of all joints that touch a domain, law by law.
    pub fn of_domain(
        scene: &Scene,
        plan: &Plan,
        strength: &[f64],
        owners: &Owners,
        domain: u32,
    ) -> Vec<Vec<Self>> {
        let of_law = |law: usize| {
            let is_here =
                |j: &&PlannedJoint| j.law as usize == law && owners.owned(&j.corners, domain) != 0;
            let count = plan.joints.iter().filter(is_here).count();
            let lanes = plan.joints.iter().filter(is_here).map(|joint| Lane {
                strength: strength[joint.element as usize],
                corners: joint.corners,
                element: joint.element,
                owned: owners.owned(&joint.corners, domain),
                reports: owners.reporter(&joint.corners) == domain,
            });
            let mut blocks = Vec::with_capacity(count.div_ceil(LANES));
            let mut lanes = lanes;
            while let Some(first) = lanes.next() {
                let mut block = [Some(first), None, None, None];
                block[1..].fill_with(|| lanes.next());
                blocks.push(Self::new(block));
            }
            blocks
        };
        (0..scene.cohesive_laws.len()).map(of_law).collect()
    }

    /// From at least one joint, the first lanes first.
    fn new(lanes: [Option<Lane>; LANES]) -> Self {
        let last = lanes.iter().flatten().last().copied();
        let filled = lanes.map(|lane| lane.or(last).unwrap_or_else(|| unreachable!("no lane")));
        let (mut owned, mut live, mut reports, mut differ) = (0, 0, 0, true);
        for (i, lane) in lanes.iter().enumerate() {
            let Some(lane) = lane else { continue };
            owned |= lane.owned << (4 * i);
            live |= 1 << i;
            reports |= u8::from(lane.reports) << i;
            let [a, b, c, d] = lane.corners;
            differ &= a != b && a != c && a != d && b != c && b != d && c != d;
        }
        let elements = filled.map(|lane| lane.element);
        Self {
            strength: filled.map(|lane| lane.strength),
            corners: [0, 1, 2, 3].map(|i| filled.map(|lane| lane.corners[i])),
            elements,
            largest_node: filled.iter().flat_map(|lane| lane.corners).max().unwrap_or(0),
            largest_element: elements.into_iter().max().unwrap_or(0),
            owned,
            live,
            reports,
            is_plain: differ && owned == ALL,
        }
    }

    fn lane(&self, lane: usize) -> Option<Lane> {
        (self.live & 1 << lane != 0).then(|| Lane {
            strength: self.strength[lane],
            corners: self.corners.map(|nodes| nodes[lane]),
            element: self.elements[lane],
            owned: self.owned >> (4 * lane) & 0b1111,
            reports: self.reports & 1 << lane != 0,
        })
    }

    /// Closes the gaps that failed joints have left, in place.
    pub fn pack(blocks: &mut Vec<Self>) {
        let (mut packed, mut waiting, mut count) = (0, [None; LANES], 0);
        for block in 0..blocks.len() {
            for lane in 0..LANES {
                let Some(joint) = blocks[block].lane(lane) else { continue };
                waiting[count] = Some(joint);
                count += 1;
                if count == LANES {
                    // never ahead of the block that is being read
                    blocks[packed] = Self::new(std::mem::take(&mut waiting));
                    (packed, count) = (packed + 1, 0);
                }
            }
        }
        if count > 0 {
            blocks[packed] = Self::new(waiting);
            packed += 1;
        }
        blocks.truncate(packed);
    }

    fn bury(&mut self, lane: usize) {
        self.live &= !(1 << lane);
        self.reports &= !(1 << lane);
        self.owned &= !(0b1111 << (4 * lane));
        self.is_plain = false;
    }
}

/// Forces of the live joints of a law, elements ascending. A joint that fails still acts in
/// this step.
pub(super) fn add_forces(
    blocks: &mut [JointBlock],
    law: usize,
    step: &Step<'_>,
    failed: &mut Vec<FailedJoint>,
) {
    if !blocks.is_empty() {
        lanes::run(Sweep { blocks, law, step, failed });
    }
}

struct Sweep<'a> {
    blocks: &'a mut [JointBlock],
    law: usize,
    step: &'a Step<'a>,
    failed: &'a mut Vec<FailedJoint>,
}

/// Forces of the three points of four joints.
type PointForces = [[[f64; 2]; LANES]; 3];

impl Kernel for Sweep<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let step = self.step;
        let law = &step.scene.cohesive_laws[self.law];
        let constants = LawLanes::<L>::new(law);
        let changes_strength = law.cohesion > 0.0;
        let places = &step.scene.nodes.current[..];
        for block in self.blocks {
            block.check(step);
            // SAFETY: just checked
            let corners = unsafe { gather::<L, 4>(places, &block.corners) };
            let response = intact::evaluate(&constants, corners, L::load(&block.strength));
            let [[sx, sy], [mx, my], [ex, ey]] = response.point_forces;
            let softening = response.softening as u8 & block.live;
            if softening == 0 && block.is_plain {
                response.strength.store(&mut block.strength);
                if changes_strength {
                    block.report(step);
                }
                let forces = [L::split(sx, sy), L::split(mx, my), L::split(ex, ey)];
                block.add::<L>(&forces, step);
                continue;
            }
            let mut forces = [L::unpair(sx, sy), L::unpair(mx, my), L::unpair(ex, ey)];
            let mut strength = response.strength.array();
            let broken = block.soften(softening, law, places, &mut strength, &mut forces);
            block.strength = strength;
            if changes_strength {
                block.report(step);
            }
            block.add_where_owned(&forces, step);
            if broken != 0 {
                block.fail(broken, self.law, self.failed);
            }
        }
    }
}

impl JointBlock {
    /// Invariant of all that is read and written without looking: nodes and elements of the
    /// block are there.
    ///
    /// # Panics
    /// If they are not.
    #[inline(always)]
    fn check(&self, step: &Step<'_>) {
        let node = self.largest_node as usize;
        assert!(node < step.scene.nodes.current.len() && node < step.force.len());
        assert!((self.largest_element as usize) < step.strength.len());
    }

    /// Evaluates joints that soften one by one. Gives the failed point of each, two bits per
    /// lane, 0 for none.
    #[inline(never)]
    fn soften(
        &self,
        softening: u8,
        law: &CohesiveLaw,
        places: &[Vec2],
        strength: &mut [f64; LANES],
        forces: &mut PointForces,
    ) -> u8 {
        let mut broken = 0;
        for lane in (0..LANES).filter(|lane| softening & 1 << lane != 0) {
            let corners = self.corners.map(|nodes| places[nodes[lane] as usize]);
            strength[lane] = self.strength[lane];
            let response = joint2::evaluate::<SplitRules>(law, &corners, &mut strength[lane], None);
            for (forces, force) in forces.iter_mut().zip(&response.point_forces) {
                forces[lane] = (*force).into();
            }
            // the second point that fails is never the first of the three
            broken |= response.failed_point.unwrap_or(0) << (2 * lane);
        }
        broken
    }

    #[inline(always)]
    fn report(&self, step: &Step<'_>) {
        for lane in 0..LANES {
            if self.reports & 1 << lane != 0 {
                // SAFETY: checked by the caller; only this domain reports this element
                let strength = unsafe { step.strength.entry(self.elements[lane] as usize) };
                *strength = self.strength[lane];
            }
        }
    }

    /// Adds the forces of the start, the middle and the end to those of nodes that differ.
    #[inline(always)]
    fn add<L: Lanes>(&self, forces: &[[L::Pair; LANES]; 3], step: &Step<'_>) {
        let [starts, middles, ends] = forces;
        for lane in 0..LANES {
            let (start, middle, end) = (starts[lane], middles[lane], ends[lane]);
            let [a, b, c, d] = &self.corners;
            // SAFETY: checked by the caller; the domain owns all these nodes
            let force = |node: u32| &mut unsafe { step.force.entry(node as usize) }.data.0[0];
            let (a, d) = (a[lane], d[lane]);
            let (b, c) = (b[lane], c[lane]);
            (L::Pair::load(force(a)) - start - middle).store(force(a));
            (L::Pair::load(force(d)) + start + middle).store(force(d));
            (L::Pair::load(force(b)) - middle - end).store(force(b));
            (L::Pair::load(force(c)) + middle + end).store(force(c));
        }
    }

    /// Adds the forces on the nodes that the domain owns.
    #[cold]
    #[inline(never)]
    fn add_where_owned(&self, forces: &PointForces, step: &Step<'_>) {
        self.check(step);
        for lane in 0..LANES {
            let add = |i: usize, force: Vec2| {
                if self.owned & 1 << (4 * lane + i) != 0 {
                    // SAFETY: just checked; the domain owns this node
                    *unsafe { step.force.entry(self.corners[i][lane] as usize) } += force;
                }
            };
            for point in 0..3 {
                let force = Vec2::from(forces[point][lane]);
                if point < 2 {
                    add(0, -force);
                    add(3, force);
                }
                if point > 0 {
                    add(1, -force);
                    add(2, force);
                }
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn fail(&mut self, broken: u8, law: usize, failed: &mut Vec<FailedJoint>) {
        for lane in 0..LANES {
            let point = broken >> (2 * lane) & 0b11;
            if point == 0 {
                continue;
            }
            if self.reports & 1 << lane != 0 {
                let joint = PlannedJoint {
                    element: self.elements[lane],
                    law: law as u32,
                    corners: self.corners.map(|nodes| nodes[lane]),
                };
                failed.push(FailedJoint { joint, point });
            }
            self.bury(lane);
        }
    }
}
