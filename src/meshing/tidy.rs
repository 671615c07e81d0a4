//! Closes what is too small to be a block: corners that nearly meet are made to meet.
//!
//! Where courses are cut by an arch, slivers are left. Cutting them out leaves holes; here corners
//! are moved instead, by less than a given length, until no two corners of a block and no corner
//! and edge of a block are nearer than that. Blocks that vanish leave their place to their
//! neighbours, so what is covered stays covered exactly.

use super::pattern::{Pattern, Point, distance, foot, line, without_spikes};

/// Closes gaps below `smallest` \[m\] and drops blocks that vanish; tells how many did.
pub(super) fn tidy(pattern: &mut Pattern, smallest: f64) -> usize {
    let before = pattern.blocks.len();
    while let Some(step) = next(pattern, smallest) {
        match step {
            Step::Merge { goes, stays } => merge(pattern, goes, stays),
            Step::Bend { point, edge, to } => {
                pattern.points[point] = to;
                let common = pattern.lines[edge[0]] & pattern.lines[edge[1]];
                pattern.lines[point] |= common & !line::FIXED;
                insert(pattern, point, edge);
            }
        }
    }
    before.saturating_sub(pattern.blocks.len())
}

/// One thing to do.
enum Step {
    /// One point takes the place of another.
    Merge { goes: usize, stays: usize },
    /// A point moves, and an edge goes through it.
    Bend { point: usize, edge: [usize; 2], to: Point },
}

/// The closest pair that is too close, if any can be mended.
fn next(pattern: &Pattern, smallest: f64) -> Option<Step> {
    let mut best = smallest;
    let mut step = None;
    for block in &pattern.blocks {
        let n = block.outline.len();
        for k in 0..n {
            let (a, b) = (block.outline[k], block.outline[(k + 1) % n]);
            // ends of an edge, and corners across the block
            for &b in &block.outline[k + 1..] {
                let length = distance(pattern.points[a], pattern.points[b]);
                if length < best
                    && let Some((goes, stays)) = can_merge(pattern, a, b)
                {
                    best = length;
                    step = Some(Step::Merge { goes, stays });
                }
            }
            for &p in block.outline.iter().filter(|&&p| p != a && p != b) {
                let (from, to) = (pattern.points[a], pattern.points[b]);
                let (along, edge_length) = foot(pattern.points[p], from, to);
                if along * edge_length <= smallest * 0.5
                    || (1.0 - along) * edge_length <= smallest * 0.5
                {
                    continue;
                }
                let on = [from[0] + along * (to[0] - from[0]), from[1] + along * (to[1] - from[1])];
                let gap = distance(on, pattern.points[p]);
                if gap < best
                    && let Some(to) = can_bend(pattern, p, [a, b], on)
                {
                    best = gap;
                    step = Some(Step::Bend { point: p, edge: [a, b], to });
                }
            }
        }
    }
    step
}

/// Which of two points may move to the other: the one that is less bound.
fn can_merge(pattern: &Pattern, a: usize, b: usize) -> Option<(usize, usize)> {
    let (la, lb) = (pattern.lines[a], pattern.lines[b]);
    if la & lb & line::FIXED != 0 {
        return None;
    }
    if la & lb == lb {
        Some((b, a))
    } else if la & lb == la {
        Some((a, b))
    } else {
        None
    }
}

/// Where a point and an edge can meet: on the edge if it must stay, else at the point.
fn can_bend(pattern: &Pattern, point: usize, edge: [usize; 2], on: Point) -> Option<Point> {
    let own = pattern.lines[point];
    let common = pattern.lines[edge[0]] & pattern.lines[edge[1]] & !line::FIXED;
    match (common, own) {
        (0, _) => Some(pattern.points[point]),
        (_, 0) => Some(on),
        _ => None,
    }
}

/// Lets one point take the place of another everywhere.
fn merge(pattern: &mut Pattern, goes: usize, stays: usize) {
    for block in &mut pattern.blocks {
        for p in &mut block.outline {
            if *p == goes {
                *p = stays;
            }
        }
    }
    settle(pattern);
}

/// Puts a point into both sides of an edge.
fn insert(pattern: &mut Pattern, point: usize, [a, b]: [usize; 2]) {
    for block in &mut pattern.blocks {
        let n = block.outline.len();
        let found = (0..n).find(|&k| {
            let (p, q) = (block.outline[k], block.outline[(k + 1) % n]);
            (p, q) == (a, b) || (p, q) == (b, a)
        });
        if let Some(k) = found {
            block.outline.insert(k + 1, point);
        }
    }
    settle(pattern);
}

/// Removes spikes, parts blocks that are pinched at a point, drops those without corners.
fn settle(pattern: &mut Pattern) {
    let mut parts = Vec::new();
    for mut block in std::mem::take(&mut pattern.blocks) {
        without_spikes(&mut block.outline);
        while let Some((i, j)) = pinch(&block.outline) {
            let mut part = block.clone();
            part.outline = block.outline.drain(i..j).collect();
            without_spikes(&mut part.outline);
            without_spikes(&mut block.outline);
            parts.push(part);
        }
        parts.push(block);
    }
    parts.retain(|block| block.outline.len() >= 3);
    pattern.blocks = parts;
}

/// Two places of an outline with the same point.
fn pinch(outline: &[usize]) -> Option<(usize, usize)> {
    (0..outline.len()).find_map(|i| {
        let again = outline[i + 1..].iter().position(|p| *p == outline[i])?;
        Some((i, i + 1 + again))
    })
}
