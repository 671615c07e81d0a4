use super::Simulation;
use crate::{
    mechanics::softening_triangle::{DETACHED, shrunk_corners},
    scene::ElementKind,
};

/// Damage at which a softening triangle detaches.
const FRACTURE_DAMAGE: f64 = 1.5;
/// Detection is forced by a travel of this many buffers after a fracture.
const FORCED_BUFFERS: f64 = 5.0;

impl Simulation {
    /// Softening triangles whose damage passed the limit shrink away from
    /// their neighbours on nodes of their own (spec `y2d3d.md` C.2).
    pub(super) fn fracture_triangles(&mut self) {
        let mut fractured = false;
        let batches = std::mem::take(&mut self.plan.batches);
        for batch in &batches {
            let material = &self.scene.materials[batch.material];
            if batch.kind != ElementKind::SofteningTriangle || !material.fractures {
                continue;
            }
            let row = material.damage_row as usize;
            for planned in &batch.triangles {
                let element = planned.element as usize;
                if self.scene.elements.state[row][element] > FRACTURE_DAMAGE {
                    self.scene.elements.state[row][element] = DETACHED;
                    self.detach(element, planned.corners, planned.reference.double_area);
                    fractured = true;
                }
            }
        }
        self.plan.batches = batches;
        if fractured {
            if let Some(contact) = &mut self.contact {
                contact.force_detection(FORCED_BUFFERS);
            }
            self.rebuild();
        }
    }

    fn detach(&mut self, element: usize, old: [u32; 3], reference_area: f64) {
        let nodes = &mut self.scene.nodes;
        let old = old.map(|n| n as usize);
        let corners = old.map(|n| nodes.current[n]);
        let (a, b) = (corners[1] - corners[0], corners[2] - corners[0]);
        let areas = [reference_area, a.x * b.y - a.y * b.x];
        let shrunk = shrunk_corners(&corners, self.strength[element], areas);
        let v = old.map(|n| nodes.velocity[n]);
        let centre_velocity = (v[0] + v[1] + v[2]) / 3.0;
        for i in 0..3 {
            nodes.boundary_flag[old[i]] = 1;
            let new = nodes.push_copy(old[i], 1);
            nodes.current[new] = shrunk[i];
            nodes.initial[new] = shrunk[i];
            nodes.velocity[new] = centre_velocity;
            self.scene.elements.nodes[element][i] = new as i32;
        }
    }
}
