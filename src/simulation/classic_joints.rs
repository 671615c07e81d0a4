//! Joints of the classic dialect: every joint set acts on every joint, strengths
//! lie in one store that neighbours share, and fractures have apertures (spec
//! `mechanics.md` 4.2, 7.10).

use super::{JointFailure, Simulation, emission::Emission, fracture_lines};
use crate::{
    mechanics::{
        Vec2,
        aperture::{Aperture, Surroundings, normal_stress},
        joint2::{self, classic},
    },
    scene::{CohesiveModel, JointKind},
};
use serde::{Deserialize, Serialize};

/// A broken joint makes detection due at once, m of travel.
const FORCED_TRAVEL: f64 = 1e15;

/// What the classic dialect keeps of its joints.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct ClassicJoints {
    /// Shear strengths of all points, Pa, in the original's store.
    strengths: Vec<f64>,
    /// Whether the store is the original's, in which joints three numbers apart
    /// share strengths, or that of a restart deck, in which they do not.
    is_shared: bool,
    /// Joint on each edge of each triangle, −1 for none.
    pub(super) edge_joint: Vec<[i32; 3]>,
    /// Apertures, one per element from the first joint on.
    apertures: Vec<Aperture>,
    /// Acoustic emission, likewise.
    pub(super) emissions: Vec<Emission>,
    first_joint: usize,
}

impl ClassicJoints {
    /// Strengths of the points of a joint, Pa.
    #[must_use]
    pub fn strengths(&self, element: usize) -> [f64; 3] {
        [0, 1, 2].map(|point| self.strengths[self.slot(element, point)])
    }

    /// Whether it holds what so many elements need, the first joint among which is `joint`.
    pub(super) fn fits(&self, elements: usize, joint: usize) -> bool {
        let entries = elements.checked_sub(self.first_joint);
        let is_element = |&e: &i32| e == -1 || usize::try_from(e).is_ok_and(|e| e < elements);
        self.first_joint <= joint
            && self.strengths.len() == 3 * elements + if self.is_shared { 6 } else { 0 }
            && self.edge_joint.len() == elements
            && self.edge_joint.as_flattened().iter().all(is_element)
            && entries == Some(self.apertures.len())
            && entries == Some(self.emissions.len())
    }

    fn set_strengths(&mut self, element: usize, strengths: [f64; 3]) {
        for (point, strength) in strengths.into_iter().enumerate() {
            let slot = self.slot(element, point);
            self.strengths[slot] = strength;
        }
    }

    fn slot(&self, element: usize, point: usize) -> usize {
        if self.is_shared { element + 3 * point } else { 3 * element + point }
    }

    /// What lies in the store for a column of an element's row, as restart decks
    /// show it; nothing is stored beyond the last strength.
    #[must_use]
    pub fn stored_strength(&self, element: usize, column: usize) -> f64 {
        if self.is_shared || column < 3 {
            self.strengths.get(self.slot(element, column)).copied().unwrap_or(0.0)
        } else {
            0.0
        }
    }

    /// Number of the first element that is a joint.
    #[must_use]
    pub fn first_joint(&self) -> usize {
        self.first_joint
    }

    /// Aperture of a joint.
    #[must_use]
    pub fn aperture(&self, element: usize) -> Option<&Aperture> {
        self.apertures.get(element.checked_sub(self.first_joint)?)
    }

    /// Acoustic emission of a joint.
    #[must_use]
    pub fn emission(&self, element: usize) -> Option<&Emission> {
        self.emissions.get(element.checked_sub(self.first_joint)?)
    }

    /// Joint on each edge of a triangle, −1 for none.
    #[must_use]
    pub fn joints_around(&self, triangle: usize) -> [i32; 3] {
        self.edge_joint.get(triangle).copied().unwrap_or([-1; 3])
    }
}

impl Simulation {
    /// Joints of the classic dialect, if the scene is of it.
    #[must_use]
    pub fn classic_joints(&self) -> Option<&ClassicJoints> {
        (self.scene.conventions.cohesive == CohesiveModel::Classic).then_some(&self.classic)
    }

    /// Strengths and apertures at the start of the run; what a restart deck gives
    /// is taken over.
    pub(super) fn set_up_classic_joints(&mut self) {
        let scene = &self.scene;
        let elements = &scene.elements;
        let materials = scene.materials.len();
        let is_joint = |e: &usize| elements.joint_kind[*e] != JointKind::NoJoint;
        let first_joint = (0..elements.len()).find(is_joint).unwrap_or(elements.len());
        let mut edge_joint = vec![[-1; 3]; elements.len()];
        for joint in (first_joint..elements.len()).filter(is_joint) {
            let [a, b, c, d, ..] = elements.nodes[joint];
            for (side, edge) in elements.sides[joint].into_iter().zip([(a, b), (c, d)]) {
                let Ok(triangle) = usize::try_from(side) else { continue };
                for i in 0..3 {
                    let nodes = &elements.nodes[triangle];
                    if (nodes[i], nodes[(i + 1) % 3]) == edge {
                        edge_joint[triangle][i] = joint as i32;
                    }
                }
            }
        }
        self.classic.edge_joint = edge_joint;
        if self.classic.apertures.len() + first_joint == elements.len() && self.step > 0 {
            return;
        }
        self.classic.first_joint = first_joint;
        let restart = scene.joint_restart.as_ref();
        match restart.and_then(|r| r.strengths.as_ref()) {
            Some(given) => {
                self.classic.is_shared = false;
                self.classic.strengths = given.as_flattened().to_vec();
                self.classic.strengths.resize(3 * elements.len(), 0.0);
            }
            None => {
                self.classic.is_shared = true;
                self.classic.strengths = vec![0.0; 3 * elements.len() + 6];
                for e in 0..elements.len() {
                    let property = match elements.joint_kind[e] {
                        JointKind::NoJoint => elements.property[e],
                        _ => elements.property[e] - materials as i32,
                    };
                    let law = usize::try_from(property).ok();
                    let law = law.and_then(|p| scene.cohesive_laws.get(p));
                    let cohesion = law.map_or(0.0, |law| law.cohesion);
                    self.classic.set_strengths(e, [cohesion; 3]);
                }
            }
        }
        self.classic.emissions = vec![Emission::default(); elements.len() - first_joint];
        self.classic.apertures = match restart.filter(|_| self.step > 0) {
            Some(restart) => {
                let mut apertures = restart.apertures.clone();
                apertures.resize(elements.len() - first_joint, Aperture::default());
                apertures
            }
            None => fracture_lines::initial_apertures(scene, first_joint),
        };
    }

    /// Takes every joint through a step with the law of one set.
    pub(super) fn add_classic_joint_forces(&mut self, law: usize) {
        let joints = std::mem::take(&mut self.plan.joints);
        for joint in &joints {
            let element = joint.element as usize;
            match self.scene.elements.joint_kind[element] {
                JointKind::Intact => self.add_intact_joint(law, element, joint.corners),
                JointKind::PreExisting | JointKind::Broken => {
                    self.update_aperture(law, element, joint.corners);
                }
                JointKind::FreeEdge | JointKind::NoJoint => {}
            }
        }
        self.plan.joints = joints;
    }

    fn add_intact_joint(&mut self, law: usize, element: usize, corners: [u32; 4]) {
        let nodes = corners.map(|n| n as usize);
        let at = nodes.map(|n| self.scene.nodes.current[n]);
        let mut strengths = self.classic.strengths(element);
        let cohesive = &self.scene.cohesive_laws[law];
        let (response, points) = classic::evaluate(cohesive, &at, &mut strengths);
        self.classic.set_strengths(element, strengths);
        response.scatter(nodes, &mut self.force);
        if response.softens {
            self.listen(law, element, &points);
        }
        if let Some(point) = response.failed_point {
            self.break_classic_joint(law, element, at, points[usize::from(point)].mode);
        }
    }

    /// Follows the energy that a softening joint emits.
    fn listen(&mut self, law: usize, element: usize, points: &[classic::PointState; 3]) {
        let mut energy = 0.0;
        for side in self.scene.elements.sides[element] {
            let Ok(triangle) = usize::try_from(side) else { continue };
            // masses of the step are summed property by property
            if self.scene.elements.property[triangle] > law as i32 {
                continue;
            }
            for n in self.scene.elements.corners::<3>(triangle) {
                let v = self.scene.nodes.velocity[n];
                energy += self.mass[n] * (v.x * v.x + v.y * v.y);
            }
        }
        let softening = points.iter().filter(|p| p.damage > 0.0).count();
        let emission = &mut self.classic.emissions[element - self.classic.first_joint];
        for _ in 0..softening {
            emission.listen(energy);
        }
    }

    fn break_classic_joint(&mut self, law: usize, element: usize, at: [Vec2; 4], mode: f64) {
        self.scene.elements.joint_kind[element] = JointKind::Broken;
        let index = element - self.classic.first_joint;
        let aperture = &mut self.classic.apertures[index];
        (aperture.failure_mode, aperture.entry_time) = (mode, self.time);
        self.classic.emissions[index].complete();
        if let Some(contact) = &mut self.contact {
            contact.force_travel(FORCED_TRAVEL);
        }
        let [a, b, c, d] = at;
        let (step, time, place) = (self.step, self.time, (a + b + c + d) / 4.0);
        let length = (a - b).norm();
        self.failures.push(JointFailure { element, step, time, mode, law, place, length });
    }

    fn update_aperture(&mut self, law: usize, element: usize, corners: [u32; 4]) {
        let at = corners.map(|n| self.scene.nodes.current[n as usize]);
        let (opening, sliding) = joint2::separation(&at);
        let sides = self.scene.elements.sides[element];
        let across = |side: usize| {
            let triangle = usize::try_from(sides[side]).ok();
            triangle.map_or(0.0, |e| normal_stress(&self.stress[e], at[2 * side], at[2 * side + 1]))
        };
        let normal_stresses = [across(0), across(1)];
        let cohesive = &self.scene.cohesive_laws[law];
        let duration = self.scene.ramp.map_or(0.0, |ramp| ramp.duration);
        let aperture = &mut self.classic.apertures[element - self.classic.first_joint];
        let risen = if duration > 0.0 {
            ((self.time - aperture.entry_time) / duration).min(1.0)
        } else {
            1.0
        };
        aperture.update(&Surroundings {
            opening,
            sliding,
            normal_stresses,
            fluid_pressure: risen * cohesive.rock.fluid_pressure,
            residual_friction: cohesive.residual_friction,
        });
    }
}
