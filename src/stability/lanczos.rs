//! The largest eigenvalue of weighted forces by masses, by the method of Lanczos (Golub and Van
//! Loan, Matrix Computations, 4th edition, section 10.1), without storing the basis.

use super::system::{System, Weights};
use nalgebra::{DMatrix, SVector, SymmetricEigen};

/// The highest mode.
#[derive(Debug, Clone)]
pub struct Mode<const D: usize> {
    /// Eigenvalue.
    pub value: f64,
    /// Bound of its relative error.
    pub error: f64,
    /// Displacements.
    pub shape: Vec<SVector<f64, D>>,
}

/// Steps at most.
const MOST_STEPS: usize = 160;
/// Relative error at which the iteration ends.
const ENOUGH: f64 = 2e-3;

/// The highest mode of a system; none if nothing moves or no force acts.
#[must_use]
pub fn highest<const D: usize>(system: &System<D>, weights: &Weights) -> Option<Mode<D>> {
    if !system.moves() || !system.has(weights) {
        return None;
    }
    let mut basis = Basis::new(system, weights);
    let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
    let mut top = Top { value: 0.0, error: 1.0, vector: Vec::new() };
    while diagonal.len() < MOST_STEPS {
        let Some((alpha, beta)) = basis.step() else { break };
        diagonal.push(alpha);
        let is_exhausted = beta <= 1e-12 * alpha.abs();
        if is_exhausted || diagonal.len() % 5 == 0 || diagonal.len() == MOST_STEPS {
            top = Top::of(&diagonal, &beside, beta);
            if is_exhausted || top.error < ENOUGH {
                break;
            }
        }
        beside.push(beta);
    }
    if !(top.value > 0.0 && top.value.is_finite()) {
        return None;
    }
    // the same vectors once more, now that it is known how much of each the mode has
    let mut basis = Basis::new(system, weights);
    let mut shape = vec![SVector::<f64, D>::zeros(); system.mass.len()];
    for &share in &top.vector {
        basis.add_to(&mut shape, share);
        if basis.step().is_none() {
            break;
        }
    }
    for (u, &mass) in shape.iter_mut().zip(&system.mass) {
        if mass > 0.0 {
            *u /= mass.sqrt();
        }
    }
    Some(Mode { value: top.value, error: top.error, shape })
}

/// The largest eigenvalue of the tridiagonal matrix.
struct Top {
    value: f64,
    error: f64,
    vector: Vec<f64>,
}

impl Top {
    fn of(diagonal: &[f64], beside: &[f64], beta: f64) -> Self {
        let size = diagonal.len();
        let matrix = DMatrix::from_fn(size, size, |i, j| match i.abs_diff(j) {
            0 => diagonal[i],
            1 => beside[i.min(j)],
            _ => 0.0,
        });
        let eigen = SymmetricEigen::new(matrix);
        let place = eigen.eigenvalues.imax();
        let value = eigen.eigenvalues[place];
        let vector: Vec<f64> = eigen.eigenvectors.column(place).iter().copied().collect();
        let error = beta * vector.last().copied().unwrap_or(1.0).abs() / value.abs();
        Self { value, error, vector }
    }
}

/// The vectors of the method, one after the other.
struct Basis<'a, const D: usize> {
    system: &'a System<D>,
    weights: &'a Weights,
    previous: Vec<SVector<f64, D>>,
    present: Vec<SVector<f64, D>>,
    beta: f64,
    displacement: Vec<SVector<f64, D>>,
    force: Vec<SVector<f64, D>>,
}

impl<'a, const D: usize> Basis<'a, D> {
    fn new(system: &'a System<D>, weights: &'a Weights) -> Self {
        // any start will do that has a part of every mode, and the same one each time
        let mut state = 0x2545_F491_4F6C_DD1D_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let zero = vec![SVector::zeros(); system.mass.len()];
        let mut present: Vec<SVector<f64, D>> =
            system.mass.iter().map(|_| SVector::from_fn(|_, _| random())).collect();
        for n in 0..present.len() {
            present[n] = free_part(system, n, present[n]);
        }
        let size = present.iter().map(SVector::norm_squared).sum::<f64>().sqrt();
        if size > 0.0 {
            present.iter_mut().for_each(|x| *x /= size);
        }
        let (displacement, force) = (zero.clone(), zero.clone());
        Self { system, weights, previous: zero, present, beta: 0.0, displacement, force }
    }

    fn add_to(&self, sum: &mut [SVector<f64, D>], share: f64) {
        for (sum, x) in sum.iter_mut().zip(&self.present) {
            *sum += x * share;
        }
    }

    /// Goes on to the next vector: the entries of the tridiagonal matrix, if there is one more.
    fn step(&mut self) -> Option<(f64, f64)> {
        let system = self.system;
        for (n, u) in self.displacement.iter_mut().enumerate() {
            *u = match system.mass[n] {
                mass if mass > 0.0 => self.present[n] / mass.sqrt(),
                _ => SVector::zeros(),
            };
        }
        self.force.fill(SVector::zeros());
        system.add_forces(self.weights, &self.displacement, &mut self.force);
        let mut alpha = 0.0;
        for n in 0..self.force.len() {
            let force = free_part(system, n, self.force[n]);
            self.force[n] = match system.mass[n] {
                mass if mass > 0.0 => force / mass.sqrt(),
                _ => SVector::zeros(),
            };
            alpha += self.force[n].dot(&self.present[n]);
        }
        let mut squared = 0.0;
        for n in 0..self.force.len() {
            let next = self.force[n] - self.present[n] * alpha - self.previous[n] * self.beta;
            self.previous[n] = self.present[n];
            self.present[n] = next;
            squared += next.norm_squared();
        }
        let beta = squared.sqrt();
        if !alpha.is_finite() || !beta.is_finite() {
            return None;
        }
        if beta > 0.0 {
            self.present.iter_mut().for_each(|x| *x /= beta);
        }
        self.beta = beta;
        Some((alpha, beta))
    }
}

fn free_part<const D: usize>(
    system: &System<D>,
    node: usize,
    vector: SVector<f64, D>,
) -> SVector<f64, D> {
    match (&system.free[node], system.mass[node] > 0.0) {
        (_, false) => SVector::zeros(),
        (None, true) => vector,
        (Some(projector), true) => projector * vector,
    }
}
