use super::{
    Contactor, Tetrahedron, Vec3,
    polygon::Polygon,
    pressure::{Potential, Resultant},
    section::View,
    shares,
    signs::Signs,
};
use crate::lanes::Lanes;

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
/// each of them the contactor's; and with twice the area that each acts on, m².
///
/// `active` are the pairs of faces that may do something (bit `4 * target face + contactor face`);
/// `penalty` is that of the couple, Pa.
#[inline(always)]
pub(super) fn overlap_in<L: Lanes>(
    target: &Tetrahedron,
    contactor: &Contactor,
    active: u16,
    penalty: f64,
    mut exert: impl FnMut(FaceForce, f64),
) {
    let faces = active | active >> 8;
    let faces = faces | faces >> 4;
    let mut views = [None; 4];
    for face in 0..4 {
        if faces & 1 << face != 0 {
            views[face] = Some(View::new(target, &contactor.frames[face]));
        }
    }
    let mut polygon = Polygon::empty();
    let mut pairs = active;
    while pairs != 0 {
        let pair = pairs.trailing_zeros() as usize;
        pairs &= pairs - 1;
        let (target_face, face) = (pair / 4, pair % 4);
        let Some(view) = views[face].as_ref().filter(|view| view.cuts(target_face)) else {
            continue;
        };
        let frame = &contactor.frames[face];
        let section = view.section::<L>(target_face);
        if !polygon.intersect(&section, frame, Signs::of::<L>(&section, frame)) {
            continue;
        }
        let potential = Potential::new(view, frame, target_face);
        let resultant = Resultant::of(&polygon, &potential, penalty);
        if resultant.force == 0.0 {
            continue;
        }
        let force = FaceForce {
            normal: frame.normal,
            target: shares::of_target(view, target_face, potential.volume, &resultant),
            contactor: shares::of_contactor(frame, face, &resultant),
        };
        exert(force, polygon.double_area());
    }
}
