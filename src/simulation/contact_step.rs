use super::Simulation;

impl Simulation {
    /// Detection when it is due, then the forces of all couples.
    pub(super) fn add_contact_forces(&mut self) {
        let Some(contact) = &mut self.contact else { return };
        let scene = &mut self.scene;
        let dt = scene.control.time_step;
        contact.detect(&scene.nodes, &mut scene.elements, &scene.materials, dt);
        contact.interact(&scene.nodes, dt, &mut self.force);
    }
}
