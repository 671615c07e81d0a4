//! Elastic triangles of a domain, four at a time.

use super::{
    super::{
        extra_loads::{ExtraLoads, LoadedTriangle},
        plan::PlannedTriangle,
    },
    Step,
    owners::Owners,
};
use crate::{
    lanes::{self, Kernel, LANES, Lanes, Pair as _},
    mechanics::{
        Vec2,
        triangle::{
            StressLaw,
            lanes::{LinearLanes, NeoHookeanLanes, ReferenceLanes, StressLanes, respond},
        },
    },
    scene::Nodes,
};
use nalgebra::Matrix2;

/// All corners of all lanes.
const ALL: u16 = (1 << (3 * LANES)) - 1;

/// Four triangles that follow each other in a batch; the last ones of a list repeat the last
/// triangle, without effect.
#[derive(Debug, Clone)]
pub(super) struct TriangleBlock {
    reference: ReferenceLanes,
    /// First, second and third corners.
    corners: [[u32; LANES]; 3],
    elements: [u32; LANES],
    /// The largest node among the corners and the largest of the elements.
    largest_node: u32,
    largest_element: u32,
    /// Bit `3 * lane + i`: the domain owns corner `i`.
    owned: u16,
    /// Lanes whose stress this domain reports.
    reports: u8,
    /// Lanes on whose nodes more acts than the stress.
    loaded: u8,
}

impl TriangleBlock {
    /// Blocks of all triangles that touch a domain.
    pub fn of_domain(triangles: &[PlannedTriangle], owners: &Owners, domain: u32) -> Vec<Self> {
        let is_here = |t: &&PlannedTriangle| owners.owned(&t.corners, domain) != 0;
        let count = triangles.iter().filter(is_here).count();
        let mut blocks = Vec::with_capacity(count.div_ceil(LANES));
        let mut here = triangles.iter().filter(is_here);
        while let Some(first) = here.next() {
            let mut lanes = [Some(first), None, None, None];
            lanes[1..].fill_with(|| here.next());
            blocks.push(Self::new(lanes, owners, domain));
        }
        blocks
    }

    fn new(lanes: [Option<&PlannedTriangle>; LANES], owners: &Owners, domain: u32) -> Self {
        let last = lanes.iter().flatten().last().copied();
        let filled = lanes.map(|lane| lane.or(last).unwrap_or_else(|| unreachable!("no lane")));
        let (mut owned, mut reports, mut loaded) = (0, 0, 0);
        for (lane, triangle) in lanes.iter().enumerate() {
            let Some(triangle) = triangle else { continue };
            owned |= owners.owned(&triangle.corners, domain) << (3 * lane);
            reports |= u8::from(owners.reporter(&triangle.corners) == domain) << lane;
            loaded |= u8::from(triangle.has_extras) << lane;
        }
        let elements = filled.map(|t| t.element);
        let nodes = filled.iter().flat_map(|t| t.corners);
        Self {
            reference: ReferenceLanes::new(filled.map(|t| &t.reference)),
            corners: [0, 1, 2].map(|i| filled.map(|t| t.corners[i])),
            elements,
            largest_node: nodes.max().unwrap_or(0),
            largest_element: elements.into_iter().max().unwrap_or(0),
            owned,
            reports,
            loaded,
        }
    }
}

/// Stresses and forces of the triangles of a batch, elements ascending, nodes of an element in
/// turn, the loads of the opposite edge right after each node.
pub(super) fn add_forces(blocks: &[TriangleBlock], batch: usize, step: &Step<'_>) {
    match &step.plan.batches[batch].law {
        StressLaw::NeoHookean(law) => {
            let constants = NeoHookean(law);
            sweep(blocks, batch, step, constants, law.viscosity != 0.0);
        }
        StressLaw::Linear(law) => {
            sweep(blocks, batch, step, Linear(law), law.viscosity != 0.0);
        }
    }
}

fn sweep<C: Constants>(
    blocks: &[TriangleBlock],
    batch: usize,
    step: &Step<'_>,
    constants: C,
    is_viscous: bool,
) {
    if step.keeps_stress {
        lanes::run(Sweep::<C, true, true> { blocks, batch, step, constants });
    } else if is_viscous {
        lanes::run(Sweep::<C, true, false> { blocks, batch, step, constants });
    } else {
        lanes::run(Sweep::<C, false, false> { blocks, batch, step, constants });
    }
}

/// Constants of a stress law for lanes of any kind.
trait Constants: Copy {
    type Of<L: Lanes>: StressLanes<L>;
    fn lanes<L: Lanes>(self) -> Self::Of<L>;
}

#[derive(Clone, Copy)]
struct NeoHookean<'a>(&'a crate::mechanics::triangle::Elasticity);

impl Constants for NeoHookean<'_> {
    type Of<L: Lanes> = NeoHookeanLanes<L>;

    #[inline(always)]
    fn lanes<L: Lanes>(self) -> NeoHookeanLanes<L> {
        NeoHookeanLanes::new(self.0)
    }
}

#[derive(Clone, Copy)]
struct Linear<'a>(&'a crate::mechanics::triangle::LinearElasticity);

impl Constants for Linear<'_> {
    type Of<L: Lanes> = LinearLanes<L>;

    #[inline(always)]
    fn lanes<L: Lanes>(self) -> LinearLanes<L> {
        LinearLanes::new(self.0)
    }
}

struct Sweep<'a, C, const VISCOUS: bool, const STRESS: bool> {
    blocks: &'a [TriangleBlock],
    batch: usize,
    step: &'a Step<'a>,
    constants: C,
}

impl<C: Constants, const VISCOUS: bool, const STRESS: bool> Kernel
    for Sweep<'_, C, VISCOUS, STRESS>
{
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let law = self.constants.lanes::<L>();
        let step = self.step;
        let nodes = &step.scene.nodes;
        for block in self.blocks {
            block.check(step);
            // SAFETY: just checked
            let (corners, velocities) = unsafe {
                (gather(&nodes.current, &block.corners), gather(&nodes.velocity, &block.corners))
            };
            let response =
                respond::<L, _, VISCOUS, STRESS>(&law, &block.reference, corners, velocities);
            if STRESS {
                let [xx, xy, yy] = response.stress;
                block.report([xx.array(), xy.array(), yy.array()], step);
            }
            let [[ax, ay], [bx, by], [cx, cy]] = response.forces;
            if block.owned == ALL && block.loaded == 0 {
                let forces = [L::split(ax, ay), L::split(bx, by), L::split(cx, cy)];
                for lane in 0..LANES {
                    for i in 0..3 {
                        let node = block.corners[i][lane] as usize;
                        // SAFETY: just checked; the domain owns all these nodes
                        let force = &mut unsafe { step.force.entry(node) }.data.0[0];
                        (L::Pair::load(force) + forces[i][lane]).store(force);
                    }
                }
            } else {
                let forces = [L::unpair(ax, ay), L::unpair(bx, by), L::unpair(cx, cy)];
                block.add_where_owned(&forces, self.batch, step);
            }
        }
    }
}

impl TriangleBlock {
    /// Invariant of all that is read and written without looking: nodes and elements of the
    /// block are there.
    ///
    /// # Panics
    /// If they are not.
    #[inline(always)]
    fn check(&self, step: &Step<'_>) {
        let node = self.largest_node as usize;
        let Nodes { current, velocity, .. } = &step.scene.nodes;
        assert!(node < current.len() && node < velocity.len() && node < step.force.len());
        assert!((self.largest_element as usize) < step.stress.len());
    }

    #[inline(always)]
    fn report(&self, [xx, xy, yy]: [[f64; LANES]; 3], step: &Step<'_>) {
        for lane in 0..LANES {
            if self.reports & 1 << lane != 0 {
                // SAFETY: checked by the caller; only this domain reports this element
                let stress = unsafe { step.stress.entry(self.elements[lane] as usize) };
                *stress = Matrix2::new(xx[lane], xy[lane], xy[lane], yy[lane]);
            }
        }
    }

    /// Adds the forces on the nodes that the domain owns, and what else acts on them.
    #[cold]
    #[inline(never)]
    fn add_where_owned(&self, forces: &[[[f64; 2]; LANES]; 3], batch: usize, step: &Step<'_>) {
        self.check(step);
        for lane in 0..LANES {
            let nodes = [0, 1, 2].map(|i| self.corners[i][lane]);
            let owns = |i: usize| self.owned & 1 << (3 * lane + i) != 0;
            let internal = [0, 1, 2].map(|i| Vec2::from(forces[i][lane]));
            if self.loaded & 1 << lane == 0 {
                for i in (0..3).filter(|&i| owns(i)) {
                    // SAFETY: just checked; the domain owns this node
                    *unsafe { step.force.entry(nodes[i] as usize) } += internal[i];
                }
                continue;
            }
            let corners = nodes.map(|n| step.scene.nodes.current[n as usize]);
            let triangle =
                LoadedTriangle::new(step.scene, &step.plan.batches[batch], &nodes, &corners);
            let loads = ExtraLoads::new(step.scene, step.edge_factors, step.time);
            let mut sums = [Vec2::zeros(); 3];
            for i in (0..3).filter(|&i| owns(i)) {
                // SAFETY: just checked; the domain owns this node
                sums[i] = *unsafe { step.force.entry(nodes[i] as usize) };
            }
            for i in 0..3 {
                sums[i] += internal[i];
                loads.apply(i, &triangle, &mut sums);
            }
            for i in (0..3).filter(|&i| owns(i)) {
                // SAFETY: just checked; the domain owns this node
                *unsafe { step.force.entry(nodes[i] as usize) } = sums[i];
            }
        }
    }
}

/// Values at the corners of four triangles or joints.
///
/// # Safety
/// All corners are below the number of values.
#[inline(always)]
pub(super) unsafe fn gather<L: Lanes, const N: usize>(
    values: &[Vec2],
    corners: &[[u32; LANES]; N],
) -> [[L; 2]; N] {
    let mut gathered = [[L::splat(0.0); 2]; N];
    for i in 0..N {
        let [a, b, c, d] = corners[i];
        // SAFETY: the caller's promise
        gathered[i] = unsafe {
            L::pairs([pair(values, a), pair(values, b), pair(values, c), pair(values, d)])
        };
    }
    gathered
}

/// # Safety
/// `index` is below the number of values.
#[inline(always)]
unsafe fn pair(values: &[Vec2], index: u32) -> &[f64; 2] {
    // SAFETY: the caller's promise
    let value = unsafe { values.get_unchecked(index as usize) };
    &value.data.0[0]
}
