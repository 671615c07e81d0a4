//! Square sheets on a held base: elastic, jointed, bursting.

use super::plane_deck::{Joints, PlaneDeck};

/// Edge of a cell of two triangles, m.
const CELL: f64 = 0.05;

/// Joints of the speed scenes of the original.
const STRONG: Joints =
    Joints { tensile_pa: 3e6, shear_pa: 5e6, fracture_energy_n_m: 50.0, penalty_pa: 2e11 };

/// Joints that break when triangles move a little against each other.
const WEAK: Joints =
    Joints { tensile_pa: 1e5, shear_pa: 1e5, fracture_energy_n_m: 0.01, penalty_pa: 2e11 };

/// A sheet without joints and contact, of about so many triangles.
pub(super) fn elastic(triangles: usize) -> PlaneDeck {
    sheet(triangles, 1e-6)
}

/// The same with joints between all triangles, without contact.
pub(super) fn jointed(triangles: usize) -> PlaneDeck {
    PlaneDeck { joints: Some(STRONG), ..sheet(triangles, 2e-7) }
}

/// The same with contact, in which bonded neighbours are couples.
pub(super) fn jointed_in_contact(triangles: usize) -> PlaneDeck {
    PlaneDeck { buffer_m: Some(0.005), ..jointed(triangles) }
}

/// A sheet that bursts: its nodes run to the middle, each with a velocity of its own besides, so
/// that all joints break in the first steps and the triangles press on each other.
pub(super) fn debris(triangles: usize) -> PlaneDeck {
    let mut deck = PlaneDeck { joints: Some(WEAK), ..jointed_in_contact(triangles) };
    let half = 0.5 * CELL * cells(triangles) as f64;
    let mut random = Random(0x2545_F491_4F6C_DD1D);
    for (velocity, &[x, y]) in deck.velocities.iter_mut().zip(&deck.nodes) {
        let inward = |x: f64| 2.0 * (half - x) / half;
        *velocity = [inward(x) + 5.0 * random.next(), inward(y) + 5.0 * random.next()];
    }
    deck
}

/// Cells along an edge of a sheet of about so many triangles.
fn cells(triangles: usize) -> usize {
    ((triangles as f64 / 2.0).sqrt().round() as usize).max(1)
}

/// Cells from left to right and upwards, diagonals in turn; nodes are numbered as cells meet them.
fn sheet(triangles: usize, step_s: f64) -> PlaneDeck {
    let cells = cells(triangles);
    let mut deck = PlaneDeck::empty(step_s);
    let mut numbers = vec![usize::MAX; (cells + 1) * (cells + 1)];
    for j in 0..cells {
        for i in 0..cells {
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
            let [a, b, c, d] = corners.map(|[i, j]| {
                let number = &mut numbers[j * (cells + 1) + i];
                if *number == usize::MAX {
                    *number = deck.node([i as f64 * CELL, j as f64 * CELL], j == 0);
                }
                *number
            });
            deck.triangles.extend(match (i + j) % 2 {
                0 => [[b, c, d], [b, d, a]],
                _ => [[a, b, c], [a, c, d]],
            });
        }
    }
    deck
}

/// Marsaglia's xorshift: the same numbers from -1 to 1 each time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sheets_have_the_size_that_is_asked_for() {
        for triangles in [2000, 5000, 20_000, 200_000] {
            let deck = elastic(triangles);
            let share = deck.triangles.len() as f64 / triangles as f64;
            assert!((0.97..1.03).contains(&share), "{triangles}: {}", deck.triangles.len());
        }
        let deck = elastic(5000);
        assert_eq!((deck.nodes.len(), deck.triangles.len()), (2601, 5000));
        // the first cells of the original's speed scene
        assert_eq!(deck.triangles[..4], [[1, 2, 3], [1, 3, 0], [1, 4, 5], [1, 5, 2]]);
        assert_eq!(deck.held.iter().filter(|&&held| held).count(), 51);
    }

    #[test]
    fn random_numbers_spread_over_their_range() {
        let mut random = Random(1);
        let numbers: Vec<f64> = (0..1000).map(|_| random.next()).collect();
        let mean = numbers.iter().sum::<f64>() / 1000.0;
        assert!(mean.abs() < 0.06 && numbers.iter().all(|x| x.abs() <= 1.0), "{mean}");
        assert!(numbers.iter().any(|x| *x < -0.9) && numbers.iter().any(|x| *x > 0.9));
    }
}
