//! Stress and strain of a triangle as Y-Geo has them at output (mechanics.md, 2.1 and 2.2).

use super::deck::Deck;

type Matrix = [[f64; 2]; 2];

/// The columns are the edges from the first corner.
fn edges(corners: [[f64; 2]; 3]) -> Matrix {
    let [a, b, c] = corners;
    [[b[0] - a[0], c[0] - a[0]], [b[1] - a[1], c[1] - a[1]]]
}

fn determinant(m: Matrix) -> f64 {
    m[0][0] * m[1][1] - m[1][0] * m[0][1]
}

fn inverse(m: Matrix) -> Matrix {
    let d = determinant(m);
    [[m[1][1] / d, -m[0][1] / d], [-m[1][0] / d, m[0][0] / d]]
}

fn each(value: impl Fn(usize, usize) -> f64) -> Matrix {
    [[value(0, 0), value(0, 1)], [value(1, 0), value(1, 1)]]
}

fn product(a: Matrix, b: Matrix) -> Matrix {
    each(|i, j| 0.0 + a[i][0] * b[0][j] + a[i][1] * b[1][j])
}

/// Stress and strain for the isotropic materials of types 1, 5 and 6.
pub fn stress_and_strain(
    deck: &Deck,
    material: usize,
    initial: [[f64; 2]; 3],
    present: [[f64; 2]; 3],
    velocities: [[f64; 2]; 3],
) -> (Matrix, Matrix) {
    let property = |keyword: &str| deck.entry(&format!("YDPE/{keyword}"), material);
    assert_eq!(property("I1USAN"), 0.0, "isotropic");
    let (undeformed, deformed) = (edges(initial), edges(present));
    let gradient = product(deformed, inverse(undeformed));
    let rate = product(edges(velocities), inverse(deformed));
    let stretch =
        each(|i, j| 0.0 + gradient[i][0] * gradient[j][0] + gradient[i][1] * gradient[j][1]);
    let strain = each(|i, j| 0.5 * stretch[i][j] - if i == j { 0.5 } else { 0.0 });
    let damping = property("D1PEKS");
    let damped = each(|i, j| damping * (0.5 * (rate[i][j] + rate[j][i])));
    let stress = match property("I1PTYP") as i64 {
        1 => {
            let (mu, lambda) = (property("D1PEMU"), property("D1PELA"));
            let (before, now) = (determinant(undeformed), determinant(deformed));
            each(|i, j| {
                let deviator = 2.0 * mu * strain[i][j] * (before / now) + damped[i][j];
                if i == j { deviator + lambda * (now / before - before / now) } else { deviator }
            })
        }
        kind => {
            let (young, poisson) = (property("D1PEEM"), property("D1PENU"));
            let (factor, own) = match kind {
                5 => (young / (1.0 - poisson * poisson), 1.0),
                6 => (young / ((1.0 + poisson) * (1.0 - 2.0 * poisson)), 1.0 - poisson),
                _ => panic!("material type {kind}"),
            };
            each(|i, j| {
                if i == j {
                    factor * (own * strain[i][i] + poisson * strain[1 - i][1 - i]) + damped[i][i]
                } else {
                    young / (1.0 + poisson) * strain[i][j] + damped[i][j]
                }
            })
        }
    };
    (stress, strain)
}
