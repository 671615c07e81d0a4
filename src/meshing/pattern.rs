//! Blocks as polygons that share their corners: a division of the plane before it is a mesh.

use super::MeshingError;

/// A point of the plane: abscissa and ordinate \[m\].
pub type Point = [f64; 2];

/// Points nearer than this are one point \[m\].
pub(super) const SAME: f64 = 1e-9;

/// Lines on which a point has to stay when corners are moved; one bit each.
pub(super) mod line {
    /// The point may not move at all.
    pub const FIXED: u32 = 1;
    /// The line of symmetry.
    pub const CENTRE: u32 = 2;
    /// The ground.
    pub const BOTTOM: u32 = 4;
    /// The top.
    pub const TOP: u32 = 8;
    /// The end of the masonry.
    pub const END: u32 = 16;
    /// The outer face of ring and footing.
    pub const RING: u32 = 32;
}

/// A block: a polygon of shared points, counter-clockwise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Block {
    /// Corners, and points of neighbours on the edges between them.
    pub outline: Vec<usize>,
    /// What it is made of: an index into the model's materials.
    pub material: usize,
    /// Whether it is one half of a block that lies across the line of symmetry.
    pub centred: bool,
}

/// Blocks and the points that they share.
#[derive(Debug, Clone, Default)]
pub(super) struct Pattern {
    /// Places of the points.
    pub points: Vec<Point>,
    /// Lines that each point has to stay on.
    pub lines: Vec<u32>,
    /// The blocks.
    pub blocks: Vec<Block>,
}

impl Pattern {
    /// The number of the point at a place; it is made if there is none.
    pub fn point(&mut self, at: Point, lines: u32) -> usize {
        let near = |p: &Point| (p[0] - at[0]).abs() < SAME && (p[1] - at[1]).abs() < SAME;
        if let Some(found) = self.points.iter().position(near) {
            self.lines[found] |= lines;
            return found;
        }
        self.points.push(at);
        self.lines.push(lines);
        self.points.len() - 1
    }

    /// Adds a block whose corners are given counter-clockwise; repeated corners count once, and a
    /// polygon without area is no block.
    pub fn block(&mut self, corners: &[(Point, u32)], material: usize, centred: bool) {
        let mut outline: Vec<usize> =
            corners.iter().map(|&(at, lines)| self.point(at, lines)).collect();
        without_spikes(&mut outline);
        if outline.len() >= 3 && area(&self.corners(&outline)) > SAME {
            self.blocks.push(Block { outline, material, centred });
        }
    }

    /// Places of the points of an outline.
    pub fn corners(&self, outline: &[usize]) -> Vec<Point> {
        outline.iter().map(|&p| self.points[p]).collect()
    }

    /// Area of a block \[m²\].
    pub fn area_of(&self, block: usize) -> f64 {
        area(&self.corners(&self.blocks[block].outline))
    }

    /// Makes every point that lies on an edge a corner of the blocks at that edge, so that
    /// neighbours share whole edges. Points that no block has any more do not count.
    pub fn conform(&mut self) {
        let mut used = vec![false; self.points.len()];
        self.blocks.iter().flat_map(|block| &block.outline).for_each(|&p| used[p] = true);
        for block in &mut self.blocks {
            let mut outline = Vec::with_capacity(block.outline.len());
            for (k, &a) in block.outline.iter().enumerate() {
                let b = block.outline[(k + 1) % block.outline.len()];
                outline.push(a);
                let (from, to) = (self.points[a], self.points[b]);
                let mut between: Vec<(f64, usize)> = (0..self.points.len())
                    .filter(|&p| used[p] && p != a && p != b)
                    .filter_map(|p| Some((inside_edge(self.points[p], from, to)?, p)))
                    .collect();
                between.sort_by(|x, y| x.0.total_cmp(&y.0));
                outline.extend(between.into_iter().map(|(_, p)| p));
            }
            block.outline = outline;
        }
    }

    /// Checks that every block runs counter-clockwise around an area.
    ///
    /// # Errors
    /// If one does not, with its place.
    pub fn check_areas(&self) -> Result<(), MeshingError> {
        for b in 0..self.blocks.len() {
            let area = self.area_of(b);
            if area.is_nan() || area <= 0.0 {
                let [x, y] = middle(&self.corners(&self.blocks[b].outline));
                return Err(MeshingError::FlatBlock { x, y, area });
            }
        }
        Ok(())
    }
}

/// Area of a polygon, positive if it runs counter-clockwise \[m²\].
pub(super) fn area(corners: &[Point]) -> f64 {
    let n = corners.len();
    let twice: f64 = (0..n)
        .map(|k| {
            let ([x0, y0], [x1, y1]) = (corners[k], corners[(k + 1) % n]);
            x0 * y1 - x1 * y0
        })
        .sum();
    twice / 2.0
}

/// Mean of the corners.
pub(super) fn middle(corners: &[Point]) -> Point {
    let n = corners.len().max(1) as f64;
    let sum = corners.iter().fold([0.0, 0.0], |s, p| [s[0] + p[0], s[1] + p[1]]);
    [sum[0] / n, sum[1] / n]
}

/// Distance of two points \[m\].
pub(super) fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Where on an edge, from 0 to 1, a point lies that is strictly inside it.
fn inside_edge(p: Point, from: Point, to: Point) -> Option<f64> {
    let (along, length) = foot(p, from, to);
    let at = [from[0] + along * (to[0] - from[0]), from[1] + along * (to[1] - from[1])];
    let beyond = SAME / length.max(SAME);
    (along > beyond && along < 1.0 - beyond && distance(at, p) < SAME).then_some(along)
}

/// The foot of the perpendicular from a point: its place along an edge as a fraction of the edge's
/// length, and that length \[m\].
pub(super) fn foot(p: Point, from: Point, to: Point) -> (f64, f64) {
    let edge = [to[0] - from[0], to[1] - from[1]];
    let square = edge[0] * edge[0] + edge[1] * edge[1];
    let dot = (p[0] - from[0]) * edge[0] + (p[1] - from[1]) * edge[1];
    (if square > 0.0 { dot / square } else { 0.0 }, square.sqrt())
}

/// Removes repeated points and edges that are walked to and fro.
pub(super) fn without_spikes(outline: &mut Vec<usize>) {
    loop {
        let n = outline.len();
        if n < 3 {
            outline.clear();
            return;
        }
        let spike = (0..n)
            .find(|&k| outline[k] == outline[(k + 1) % n] || outline[k] == outline[(k + 2) % n]);
        let Some(k) = spike else { return };
        if outline[k] != outline[(k + 1) % n] {
            // a b a: b goes, and the second a with the next turn
            outline.remove((k + 1) % n);
        } else {
            outline.remove(k);
        }
    }
}
