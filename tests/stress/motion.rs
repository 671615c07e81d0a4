//! What a simulation has at an instant, in the plane or in space, and what of it is conserved.

use crate::support::stability_scenes::Moving;
use nalgebra::Vector3;
use ypsilon::simulation::{EnergyBalance, PlaneAudit, SpaceAudit};

pub type Vec3 = Vector3<f64>;

/// Places, velocities, forces and masses of all nodes. In the plane z is 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    pub places: Vec<Vec3>,
    pub velocities: Vec<Vec3>,
    pub forces: Vec<Vec3>,
    pub masses: Vec<f64>,
}

impl Motion {
    pub fn of(moving: &Moving) -> Self {
        match moving {
            Moving::Plane(simulation) => {
                let nodes = &simulation.scene().nodes;
                let space = |v: &[nalgebra::Vector2<f64>]| {
                    v.iter().map(|v| Vec3::new(v.x, v.y, 0.0)).collect()
                };
                Self {
                    places: space(&nodes.current),
                    velocities: space(&nodes.velocity),
                    forces: space(simulation.forces()),
                    masses: simulation.masses().to_vec(),
                }
            }
            Moving::Space(simulation) => {
                let nodes = &simulation.scene().nodes;
                Self {
                    places: nodes.current.clone(),
                    velocities: nodes.velocity.clone(),
                    forces: simulation.forces().to_vec(),
                    masses: simulation.masses().to_vec(),
                }
            }
        }
    }

    /// Whether all of it are numbers.
    pub fn is_finite(&self) -> bool {
        let vectors = [&self.places, &self.velocities, &self.forces];
        vectors.into_iter().flatten().all(|v| v.iter().all(|x| x.is_finite()))
            && self.masses.iter().all(|m| m.is_finite())
    }

    /// Σ m v.
    pub fn momentum(&self) -> Vec3 {
        self.masses.iter().zip(&self.velocities).map(|(m, v)| v * *m).sum()
    }

    /// Σ m x × v about a point.
    pub fn angular_momentum(&self, about: Vec3) -> Vec3 {
        let moved = self.places.iter().zip(&self.velocities).zip(&self.masses);
        moved.map(|((x, v), m)| (x - about).cross(v) * *m).sum()
    }

    /// Σ m x / Σ m.
    pub fn centre(&self) -> Vec3 {
        let weighted: Vec3 = self.places.iter().zip(&self.masses).map(|(x, m)| x * *m).sum();
        weighted / self.masses.iter().sum::<f64>()
    }

    /// Σ m |v|, what momentum is measured by.
    pub fn impetus(&self) -> f64 {
        self.masses.iter().zip(&self.velocities).map(|(m, v)| m * v.norm()).sum()
    }

    /// Σ m |x| |v| about a point, what angular momentum is measured by.
    pub fn spin(&self, about: Vec3) -> f64 {
        let moved = self.places.iter().zip(&self.velocities).zip(&self.masses);
        moved.map(|((x, v), m)| (x - about).norm() * v.norm() * m).sum()
    }

    /// Sum of forces and of their moments about the centre, by the sum of their sizes.
    pub fn imbalance(&self) -> [f64; 2] {
        let about = self.centre();
        let size: f64 = self.forces.iter().map(|f| f.norm()).sum();
        let arm: f64 = self.places.iter().map(|x| (x - about).norm()).fold(0.0, f64::max);
        let sum: Vec3 = self.forces.iter().sum();
        let moment: Vec3 =
            self.places.iter().zip(&self.forces).map(|(x, f)| (x - about).cross(f)).sum();
        if size > 0.0 { [sum.norm() / size, moment.norm() / (size * arm)] } else { [0.0; 2] }
    }

    /// ½ Σ m v².
    pub fn kinetic_energy(&self) -> f64 {
        self.masses.iter().zip(&self.velocities).map(|(m, v)| 0.5 * m * v.norm_squared()).sum()
    }
}

/// One step.
pub fn step(moving: &mut Moving) {
    match moving {
        Moving::Plane(simulation) => {
            simulation.evaluate_forces();
            simulation.advance();
        }
        Moving::Space(simulation) => {
            simulation.evaluate_forces();
            simulation.advance();
        }
    }
}

/// Forces of the present state.
pub fn evaluate(moving: &mut Moving) {
    match moving {
        Moving::Plane(simulation) => simulation.evaluate_forces(),
        Moving::Space(simulation) => simulation.evaluate_forces(),
    }
}

/// What was conserved over a run, and how well.
#[derive(Debug, Clone, Copy)]
pub struct Conserved {
    /// Largest error of the balance of energies by the largest energy.
    pub worst: f64,
    /// Mean error of the last tenth of the run less that of the first, by the largest energy.
    pub drift: f64,
    /// Largest change of momentum by the largest Σ m |v|.
    pub momentum: f64,
    /// Largest change of angular momentum by the largest Σ m |x| |v|.
    pub angular: f64,
    pub first: EnergyBalance,
    pub last: EnergyBalance,
}

impl Conserved {
    /// What motion and elements have at the end by what they had at the start, less 1.
    pub fn gain(&self) -> f64 {
        let energy = |b: &EnergyBalance| b.kinetic + b.strain;
        energy(&self.last) / energy(&self.first) - 1.0
    }
}

/// Runs so many steps of a length, looks at energies in each and at momentum in a thousand of them.
pub fn conserved(moving: &mut Moving, dt: f64, steps: usize) -> Conserved {
    moving.run(dt, 0);
    if let Moving::Plane(simulation) = moving {
        simulation.watch_contact_forces();
        simulation.keep_triangles();
    }
    let start = Motion::of(moving);
    let about = start.centre();
    let (mut momentum, mut angular): (f64, f64) = (0.0, 0.0);
    let (mut impetus, mut spin) = (start.impetus(), start.spin(about));
    let mut audit = Audit::new(moving);
    let tenth = (steps / 10).max(1);
    let mut sums = [0.0; 2];
    let mut first = None;
    for n in 0..steps {
        audit.step(moving);
        let balance = audit.balance();
        first.get_or_insert(balance);
        if n < tenth {
            sums[0] += balance.relative_error;
        } else if n >= steps - tenth {
            sums[1] += balance.relative_error;
        }
        if n % (steps / 1000).max(1) == 0 {
            let now = Motion::of(moving);
            assert!(now.is_finite(), "step {n}");
            momentum = momentum.max((now.momentum() - start.momentum()).norm());
            let turned = now.angular_momentum(about) - start.angular_momentum(about);
            angular = angular.max(turned.norm());
            impetus = impetus.max(now.impetus());
            spin = spin.max(now.spin(about));
        }
    }
    Conserved {
        worst: audit.worst(),
        drift: (sums[1] - sums[0]) / tenth as f64,
        momentum: if impetus > 0.0 { momentum / impetus } else { 0.0 },
        angular: if spin > 0.0 { angular / spin } else { 0.0 },
        first: first.expect("a step"),
        last: audit.balance(),
    }
}

/// The audit of a simulation of either dimension.
enum Audit {
    Plane(Box<PlaneAudit>),
    Space(Box<SpaceAudit>),
}

impl Audit {
    fn new(moving: &Moving) -> Self {
        match moving {
            Moving::Plane(simulation) => Self::Plane(Box::new(PlaneAudit::new(simulation))),
            Moving::Space(_) => Self::Space(Box::default()),
        }
    }

    fn step(&mut self, moving: &mut Moving) {
        match (self, moving) {
            (Self::Plane(audit), Moving::Plane(simulation)) => {
                simulation.evaluate_forces();
                audit.after_forces(simulation);
                simulation.advance();
                audit.after_motion(simulation);
            }
            (Self::Space(audit), Moving::Space(simulation)) => {
                simulation.evaluate_forces();
                audit.after_forces(simulation);
                simulation.advance();
                audit.after_motion(simulation);
            }
            _ => unreachable!("an audit of the other dimension"),
        }
    }

    fn balance(&self) -> EnergyBalance {
        match self {
            Self::Plane(audit) => audit.ledger().balance(),
            Self::Space(audit) => audit.ledger().balance(),
        }
    }

    fn worst(&self) -> f64 {
        match self {
            Self::Plane(audit) => audit.ledger().worst_error(),
            Self::Space(audit) => audit.ledger().worst_error(),
        }
    }
}
