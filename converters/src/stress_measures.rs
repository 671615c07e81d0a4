//! Numbers derived from a stress tensor.
//!
//! Tensors are symmetric, in the order xx, yy, zz, xy, yz, xz, tension positive.

/// A symmetric tensor: xx, yy, zz, xy, yz, xz.
pub type SymmetricTensor = [f64; 6];

/// The tensor of a plane state: xx, yy, xy and a zz of its own.
///
/// ```
/// use ypsilon_converters::stress_measures::{plane, von_mises};
/// // pure shear: √3 τ
/// assert!((von_mises(&plane(0.0, 0.0, 0.0, 2.0)) - 12.0_f64.sqrt()).abs() < 1e-15);
/// ```
pub fn plane(xx: f64, yy: f64, zz: f64, xy: f64) -> SymmetricTensor {
    [xx, yy, zz, xy, 0.0, 0.0]
}

/// Mean stress: a third of the trace.
pub fn mean(stress: &SymmetricTensor) -> f64 {
    (stress[0] + stress[1] + stress[2]) / 3.0
}

/// Von Mises equivalent stress, σzz included.
pub fn von_mises(&[xx, yy, zz, xy, yz, xz]: &SymmetricTensor) -> f64 {
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    let shear = xy * xy + yz * yz + xz * xz;
    (0.5 * normal + 3.0 * shear).sqrt()
}

/// Principal stresses, the largest first; all NaN when a component is not finite.
pub fn principal(stress: &SymmetricTensor) -> [f64; 3] {
    if !stress.iter().all(|component| component.is_finite()) {
        return [f64::NAN; 3];
    }
    let &[xx, yy, zz, xy, yz, xz] = stress;
    let mut values = if yz == 0.0 && xz == 0.0 {
        let centre = 0.5 * (xx + yy);
        let radius = (0.5 * (xx - yy)).hypot(xy);
        [centre + radius, centre - radius, zz]
    } else {
        eigenvalues([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    };
    values.sort_unstable_by(|a, b| b.total_cmp(a));
    values
}

/// Tresca equivalent stress: the difference of the largest and the smallest principal stress.
pub fn tresca(stress: &SymmetricTensor) -> f64 {
    let [largest, _, smallest] = principal(stress);
    largest - smallest
}

/// Maximum shear stress: half the Tresca stress.
pub fn maximum_shear(stress: &SymmetricTensor) -> f64 {
    0.5 * tresca(stress)
}

/// Eigenvalues by Jacobi's rotations: exact to rounding also where eigenvalues coincide, which
/// the formula with the arc cosine is not.
fn eigenvalues(mut a: [[f64; 3]; 3]) -> [f64; 3] {
    const PAIRS: [(usize, usize, usize); 3] = [(0, 1, 2), (0, 2, 1), (1, 2, 0)];
    // Convergence is quadratic: a handful of sweeps do.
    for _ in 0..32 {
        let off_diagonal = a[0][1].abs() + a[0][2].abs() + a[1][2].abs();
        let diagonal = a[0][0].abs() + a[1][1].abs() + a[2][2].abs();
        if off_diagonal <= f64::EPSILON * 1e-3 * diagonal {
            break;
        }
        for (p, q, r) in PAIRS {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            let shift = tangent * a[p][q];
            a[p][p] -= shift;
            a[q][q] += shift;
            a[p][q] = 0.0;
            a[q][p] = 0.0;
            let (rp, rq) = (a[r][p], a[r][q]);
            a[r][p] = cosine * rp - sine * rq;
            a[r][q] = sine * rp + cosine * rq;
            a[p][r] = a[r][p];
            a[q][r] = a[r][q];
        }
    }
    [a[0][0], a[1][1], a[2][2]]
}
