use super::{
    Contactor, FACES, Tetrahedron, Vec3,
    polygon::Polygon,
    pressure::{Potential, Resultant},
    section::View,
    shares,
};

/// The force between a face of the contactor and a face of the target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FaceForce {
    /// The contactor's inward normal.
    pub normal: Vec3,
    /// What each node of the target bears against the normal, N.
    pub target: [f64; 4],
    /// What each node of the contactor bears along the normal, N.
    pub contactor: [f64; 4],
}

impl FaceForce {
    /// Adds it to the forces of the nodes in the original's order.
    #[inline(always)]
    pub fn scatter(&self, target: &[u32; 4], contactor: &[u32; 4], forces: &mut [Vec3]) {
        for i in 0..4 {
            forces[contactor[i] as usize] += self.normal * self.contactor[i];
            forces[target[i] as usize] -= self.normal * self.target[i];
        }
    }
}

/// Calls `exert` with the forces of a couple, in the original's order: the target's faces, and for
/// each of them the contactor's.
///
/// `penalty` is that of the pair, Pa.
pub fn overlap(
    target: &Tetrahedron,
    contactor: &Contactor,
    penalty: f64,
    mut exert: impl FnMut(FaceForce),
) {
    let views = [0, 1, 2, 3].map(|face| View::new(target, &contactor.frames[face]));
    for target_face in 0..FACES.len() {
        for (face, view) in views.iter().enumerate() {
            if !view.cuts(target_face) {
                continue;
            }
            let frame = &contactor.frames[face];
            let section = view.section(target_face);
            let Some(polygon) = Polygon::common(&section, frame) else { continue };
            let potential = Potential::new(view, frame, target_face);
            let resultant = Resultant::of(&polygon, &potential, penalty);
            if resultant.force == 0.0 {
                continue;
            }
            exert(FaceForce {
                normal: frame.normal,
                target: shares::of_target(view, target_face, potential.volume, &resultant),
                contactor: shares::of_contactor(frame, face, &resultant),
            });
        }
    }
}
