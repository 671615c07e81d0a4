//! Couples one after the other, as the classic dialect needs it: a couple that is
//! dropped changes the sliding of the next in its chain, fractures change the
//! friction along their faces, and sums per element go to the snapshots (spec
//! `contact.md` 3.5 to 3.7).

use super::{
    clearance::clearance,
    evaluation::{Couples, Step},
    overlap2::{Couple, EdgeContact, Proximity, SideForces, TangentialLaw, overlap},
};
use crate::{
    mechanics::Vec2,
    scene::{FrictionModel, JointKind, PairProperties},
};
use serde::{Deserialize, Serialize};

/// Angle that friction along a rough fracture never exceeds, degrees.
const STEEPEST: f64 = 85.0;

/// A joint as the triangles on its sides see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FractureFace {
    /// What it is.
    pub kind: JointKind,
    /// Share of the normal stress that the rock carries, not the fluid.
    pub effective_share: f64,
    /// Mobilised asperity angle, degrees.
    pub asperity_angle: f64,
}

/// Looks joints up.
pub trait FractureFaces {
    /// The joint on an edge of a triangle, if it has one.
    fn face(&self, triangle: u32, edge: usize) -> Option<FractureFace>;
}

/// Contact forces summed by element, for snapshots.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Tally {
    /// Tangential force on each element, N.
    pub sliding_force: Vec<f64>,
    /// Force on each element by elements of other property sets, N; with the
    /// reversed sign where the target's edges are cut, as in the original.
    pub boundary_force: Vec<Vec2>,
}

impl Tally {
    /// Makes room for `elements` and forgets the sums.
    pub fn clear(&mut self, elements: usize) {
        self.sliding_force.clear();
        self.sliding_force.resize(elements, 0.0);
        self.boundary_force.clear();
        self.boundary_force.resize(elements, Vec2::zeros());
    }
}

/// Friction of a couple of triangles that may lie on fractures.
struct FractureFriction<'a, F> {
    pair: &'a PairProperties,
    model: FrictionModel,
    faces: &'a F,
    /// Target and contactor.
    elements: [u32; 2],
    /// Asperity angle of the fracture met last, degrees.
    last_angle: &'a mut f64,
    tally: Option<&'a mut Tally>,
    are_alike: bool,
}

impl<F: FractureFaces> FractureFriction<'_, F> {
    /// Friction coefficient along rough surfaces: the smaller asperity angle of
    /// the two sides on top of the angle of smooth ones.
    fn rough_friction(&mut self, face: Option<FractureFace>) -> f64 {
        let Some(face) = face else { return 0.0 };
        match face.kind {
            JointKind::FreeEdge | JointKind::PreExisting => {
                if face.kind == JointKind::PreExisting {
                    *self.last_angle = face.asperity_angle;
                }
                let faces = self.faces;
                let contactor = self.elements[1];
                let angle = (0..3)
                    .filter_map(|edge| faces.face(contactor, edge))
                    .filter(|f| f.kind.is_fracture())
                    .fold(*self.last_angle, |least, f| least.min(f.asperity_angle));
                let smooth = self.pair.friction.atan().to_degrees();
                (smooth + angle).min(STEEPEST).to_radians().tan()
            }
            JointKind::Broken => self.pair.friction,
            JointKind::Intact | JointKind::NoJoint => 0.0,
        }
    }
}

impl<F: FractureFaces> TangentialLaw for FractureFriction<'_, F> {
    fn force(&mut self, contact: &EdgeContact, sliding: &mut f64) -> f64 {
        // always an edge of the target, also where it is the contactor's that is cut
        let face = self.faces.face(self.elements[0], contact.edge);
        let share = face.filter(|f| f.kind.is_fracture()).map_or(1.0, |f| f.effective_share);
        let effective = contact.normal_force * share;
        let force = match self.model {
            FrictionModel::Coulomb => self.pair.tangential_force(sliding, effective),
            FrictionModel::BartonBandis => {
                let friction = self.rough_friction(face);
                let velocity = contact.sliding_velocity;
                if velocity == 0.0 {
                    0.0
                } else {
                    velocity * (friction * effective / velocity).abs()
                }
            }
        };
        if let Some(tally) = &mut self.tally {
            let [target, contactor] = self.elements.map(|e| e as usize);
            let n = contact.normal;
            let along = force * (n.x * n.x + n.y * n.y).sqrt();
            tally.sliding_force[contactor] += along;
            tally.sliding_force[target] -= along;
            if !self.are_alike {
                let on_contactor = Vec2::new(
                    -contact.normal_force * n.x - force * n.y,
                    -contact.normal_force * n.y + force * n.x,
                );
                tally.boundary_force[contactor] += on_contactor;
                tally.boundary_force[target] -= on_contactor;
            }
        }
        force
    }
}

/// Evaluates the couples in the order of the list and adds their forces; how many of them had to be
/// evaluated.
pub(super) fn evaluate_in_order(
    step: &Step<'_>,
    couples: Couples<'_>,
    model: FrictionModel,
    faces: &impl FractureFaces,
    mut tally: Option<&mut Tally>,
    forces: &mut [Vec2],
) -> u64 {
    let Couples { visits: list, facing, respites, sliding, chains, dropped } = couples;
    let mut evaluated = 0;
    let mut sides = [SideForces::default(); 2];
    let mut last_angle = 0.0;
    for index in 0..list.len() {
        if step.path < f64::from(respites.rest[index]) {
            continue;
        }
        evaluated += 1;
        let visit = &mut list[index];
        let bodies = facing[index].bodies();
        let [target, contactor] = bodies.map(|place| place as usize);
        let nodes = step.nodes_of(bodies);
        let pair = step.pairs.properties(visit.traits.pair());
        let couple = Couple {
            shapes: [&step.bodies.shapes[target], &step.bodies.shapes[contactor]],
            motions: [&step.bodies.motions[target], &step.bodies.motions[contactor]],
            pair,
            dt: step.dt,
            drop_distance_squared: step.drop_distance_squared(),
        };
        let mut law = FractureFriction {
            pair,
            model,
            faces,
            elements: bodies.map(|place| step.bodies.elements[place as usize]),
            last_angle: &mut last_angle,
            tally: tally.as_deref_mut(),
            are_alike: visit.traits.is_inside(),
        };
        let mut slid = *sliding.of(visit.sliding);
        match overlap(&couple, &mut law, &mut slid, &mut sides) {
            Proximity::Near => {
                sliding.keep(&mut visit.sliding, &slid);
                sides[0].scatter(nodes[0], nodes[1], forces);
                sides[1].scatter(nodes[1], nodes[0], forces);
            }
            Proximity::Beyond => {
                dropped.push(index as u32);
                chains.unlink(list, sliding, index);
            }
            Proximity::Clear if step.rests => {
                let corners = [couple.shapes[0].corners(), couple.shapes[1].corners()];
                let free = clearance(nodes, &corners, step.buffer).rest;
                respites.rest[index] = step.rest(free).unwrap_or(0.0);
            }
            Proximity::Clear => {}
        }
    }
    evaluated
}
