use super::super::plan::Plan;
use crate::scene::Scene;
use std::ops::Range;

/// Nodes of a cache line of coordinates: borders between runs of nodes lie between lines.
const LINE: usize = 4;

/// To which domain each node belongs.
#[derive(Debug)]
pub(super) struct Owners {
    owner: Vec<u32>,
    /// The nodes of each domain, where these follow each other.
    runs: Option<Vec<Range<u32>>>,
}

impl Owners {
    /// Divides the nodes into `count` domains with about the same number of elements: into runs of
    /// their numbers or into strips across the longer side of the mesh. Runs are better if they
    /// part no more elements, because a thread's nodes then lie together in memory.
    pub fn new(scene: &Scene, plan: &Plan, count: usize) -> Self {
        let nodes = scene.nodes.len();
        if count < 2 {
            let all = 0..nodes as u32;
            return Self { owner: vec![0; nodes], runs: Some(Vec::from([all])) };
        }
        let work = work(nodes, plan);
        let in_runs = divide(&(0..nodes as u32).collect::<Vec<_>>(), &work, count, LINE);
        let in_strips = divide(&along_longer_side(scene), &work, count, 1);
        let elements = plan.joints.len()
            + plan.batches.iter().map(|batch| batch.triangles.len()).sum::<usize>();
        let tolerated = parted(plan, &in_strips) + elements / FEW;
        if parted(plan, &in_runs) > tolerated {
            return Self { owner: in_strips, runs: None };
        }
        let mut runs = vec![0..0; count];
        for (node, &owner) in in_runs.iter().enumerate() {
            let run = &mut runs[owner as usize];
            *run = if run.start == run.end { node as u32 } else { run.start }..node as u32 + 1;
        }
        Self { owner: in_runs, runs: Some(runs) }
    }

    /// The nodes of each domain, where these follow each other.
    pub fn runs(&self) -> Option<&[Range<u32>]> {
        self.runs.as_deref()
    }

    /// Bit `i` is set where the domain owns corner `i`.
    pub fn owned<const N: usize>(&self, corners: &[u32; N], domain: u32) -> u16 {
        let owns = |i: usize| u16::from(self.owner[corners[i] as usize] == domain);
        (0..N).fold(0, |bits, i| bits | owns(i) << i)
    }

    /// The domain that reports what an element has become: the first of those that hold it.
    pub fn reporter<const N: usize>(&self, corners: &[u32; N]) -> u32 {
        corners.iter().map(|&n| self.owner[n as usize]).min().unwrap_or(0)
    }
}

/// One element in so many may be parted for the sake of runs.
const FEW: usize = 50;

/// Number of corners of triangles and joints at each node.
fn work(nodes: usize, plan: &Plan) -> Vec<u64> {
    let mut work = vec![0; nodes];
    let triangles = plan.batches.iter().flat_map(|batch| &batch.triangles);
    let corners = triangles.flat_map(|t| t.corners);
    for node in corners.chain(plan.joints.iter().flat_map(|j| j.corners)) {
        work[node as usize] += 1;
    }
    work
}

/// All nodes in the order in which they lie along the longer side of the mesh.
fn along_longer_side(scene: &Scene) -> Vec<u32> {
    let places = &scene.nodes.current;
    let extent = [0, 1].map(|k| {
        let along = places.iter().map(|p| p[k]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    });
    let axis = usize::from(extent[1] > extent[0]);
    let mut order: Vec<u32> = (0..places.len() as u32).collect();
    order.sort_by(|&a, &b| {
        places[a as usize][axis].total_cmp(&places[b as usize][axis]).then(a.cmp(&b))
    });
    order
}

/// Owners of nodes that are dealt out in this order, so many in a row to the same one, to
/// `count` domains with about the same work.
fn divide(order: &[u32], work: &[u64], count: usize, together: usize) -> Vec<u32> {
    let total = work.iter().sum::<u64>().max(1);
    let mut owners = vec![0; order.len()];
    let mut done = 0;
    for nodes in order.chunks(together) {
        // nodes without elements behind the last that has some go to the last domain
        let owner = (done * count as u64 / total).min(count as u64 - 1) as u32;
        for &node in nodes {
            owners[node as usize] = owner;
            done += work[node as usize];
        }
    }
    owners
}

/// Number of triangles and joints with nodes of several domains.
fn parted(plan: &Plan, owners: &[u32]) -> usize {
    let is_parted = |corners: &[u32]| {
        corners.iter().any(|&n| owners[n as usize] != owners[corners[0] as usize])
    };
    let triangles = plan.batches.iter().flat_map(|batch| &batch.triangles);
    triangles.filter(|t| is_parted(&t.corners)).count()
        + plan.joints.iter().filter(|j| is_parted(&j.corners)).count()
}
