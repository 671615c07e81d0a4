use super::super::plan::Plan;
use crate::scene::Scene;

/// To which domain each node belongs.
#[derive(Debug)]
pub(super) struct Owners(Vec<u32>);

impl Owners {
    /// Cuts the mesh into `count` strips across its longer side with about the same number of
    /// elements.
    pub fn new(scene: &Scene, plan: &Plan, count: usize) -> Self {
        let nodes = scene.nodes.len();
        let mut owners = vec![0; nodes];
        if count < 2 {
            return Self(owners);
        }
        let mut work = vec![0u64; nodes];
        let triangles = plan.batches.iter().flat_map(|batch| &batch.triangles);
        let corners = triangles.flat_map(|t| t.corners);
        for node in corners.chain(plan.joints.iter().flat_map(|j| j.corners)) {
            work[node as usize] += 1;
        }
        let places = &scene.nodes.current;
        let extent = [0, 1].map(|k| {
            let along = places.iter().map(|p| p[k]);
            along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
        });
        let axis = usize::from(extent[1] > extent[0]);
        let mut order: Vec<u32> = (0..nodes as u32).collect();
        order.sort_by(|&a, &b| {
            places[a as usize][axis].total_cmp(&places[b as usize][axis]).then(a.cmp(&b))
        });
        let total: u64 = work.iter().sum::<u64>().max(1);
        let mut done = 0;
        for node in order {
            owners[node as usize] = (done * count as u64 / total) as u32;
            done += work[node as usize];
        }
        // nodes without elements behind the last that has some
        owners.iter_mut().for_each(|owner| *owner = (*owner).min(count as u32 - 1));
        Self(owners)
    }

    /// Bit `i` is set where the domain owns corner `i`.
    pub fn owned<const N: usize>(&self, corners: &[u32; N], domain: u32) -> u16 {
        let owns = |i: usize| u16::from(self.0[corners[i] as usize] == domain);
        (0..N).fold(0, |bits, i| bits | owns(i) << i)
    }

    /// The domain that reports what an element has become: the first of those that hold it.
    pub fn reporter<const N: usize>(&self, corners: &[u32; N]) -> u32 {
        corners.iter().map(|&n| self.0[n as usize]).min().unwrap_or(0)
    }
}
