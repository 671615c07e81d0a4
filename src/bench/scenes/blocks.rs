//! Dry blocks in running bond.

use super::plane_deck::PlaneDeck;

/// Width and height of a block, m.
const BLOCK: [f64; 2] = [0.25, 0.125];

/// A wall of blocks of four triangles each, of about so many triangles. The original's speed
/// scene has 27 × 20 blocks; others have the same shape. The lowest nodes are held.
pub(super) fn running_bond(triangles: usize) -> PlaneDeck {
    let rows = (triangles as f64 / 4.0 * 20.0 / 27.0).sqrt().round().max(1.0) as usize;
    let columns = (triangles as f64 / 4.0 / rows as f64).round().max(1.0) as usize;
    let [width, height] = BLOCK;
    let mut deck = PlaneDeck { buffer_m: Some(0.01), ..PlaneDeck::empty(2e-6) };
    for row in 0..rows {
        let (y0, y1) = (row as f64 * height, (row + 1) as f64 * height);
        let offset = 0.5 * width * (row % 2) as f64;
        for column in 0..columns {
            let (x0, x1) = (column as f64 * width + offset, (column + 1) as f64 * width + offset);
            let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
            let corners = corners.map(|place| deck.node(place, row == 0 && place[1] == y0));
            let middle = deck.node([0.5 * (x0 + x1), 0.5 * (y0 + y1)], false);
            let triangles = (0..4).map(|k| [corners[k], corners[(k + 1) % 4], middle]);
            deck.triangles.extend(triangles);
        }
    }
    deck
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_wall_is_the_one_of_the_original() {
        let deck = running_bond(2160);
        assert_eq!((deck.triangles.len(), deck.nodes.len()), (2160, 2700));
        assert_eq!(deck.triangles[4], [5, 6, 9]);
        // first block of the second row
        assert_eq!(deck.nodes[27 * 5], [0.125, 0.125]);
        assert_eq!(deck.held.iter().filter(|&&held| held).count(), 54);
    }
}
