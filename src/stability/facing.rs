//! Edges of triangles that lie on each other.

use crate::mechanics::Vec2;
use std::collections::HashMap;

/// An edge at which a triangle may touch another.
#[derive(Debug, Clone)]
pub struct Side {
    /// The triangle.
    pub element: usize,
    /// Its ends, counter-clockwise.
    pub nodes: [usize; 2],
    /// Where these are, m.
    pub places: [Vec2; 2],
    /// Outward.
    pub normal: Vec2,
    /// m
    pub length: f64,
    /// Of the triangle over it, m.
    pub height: f64,
}

/// Two edges that lie on each other, or nearly so.
#[derive(Debug, Clone)]
pub struct Pair {
    /// Their places in the list.
    pub sides: [usize; 2],
    /// Points of integration at which they touch: the length that each stands for, m, and its
    /// places along both edges, 0 to 1.
    pub points: Vec<(f64, [f64; 2])>,
    /// The middle of what they have in common, along both edges.
    pub middle: [f64; 2],
}

/// Two points between 0 and 1 that integrate cubic functions exactly.
pub const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// Parts of what two edges have in common that touch, or not, by themselves.
const PARTS: usize = 4;
/// How far apart edges may be to count as touching, by the smaller height.
const NEAR: f64 = 1e-6;
/// How far they may overlap, by the smaller height.
const DEEP: f64 = 0.3;
/// Cosine of the angle between edges that count as parallel.
const PARALLEL: f64 = 0.99;

impl Pair {
    /// Nodes whose motion presses the edges together, at a place along both.
    pub fn nodes(&self, sides: &[Side], along: &[f64; 2]) -> Vec<(usize, f64)> {
        let [a, b] = self.sides.map(|s| &sides[s]);
        let [s, t] = *along;
        vec![(a.nodes[0], 1.0 - s), (a.nodes[1], s), (b.nodes[0], t - 1.0), (b.nodes[1], -t)]
    }
}

/// The edges that no other triangle shares by its nodes.
pub fn without_shared(sides: Vec<Side>) -> Vec<Side> {
    let count: HashMap<[usize; 2], usize> = sides.iter().fold(HashMap::new(), |mut map, side| {
        *map.entry(side.nodes).or_insert(0) += 1;
        map
    });
    let is_shared = |side: &Side| count.contains_key(&[side.nodes[1], side.nodes[0]]);
    sides.into_iter().filter(|side| !is_shared(side)).collect()
}

/// All pairs of edges that touch, in the order of their numbers along x.
pub fn pairs(sides: &[Side]) -> Vec<Pair> {
    let reach = |side: &Side| {
        let slack = DEEP * side.height;
        let x = side.places.map(|p| p.x);
        (x[0].min(x[1]) - slack, x[0].max(x[1]) + slack)
    };
    let mut order: Vec<usize> = (0..sides.len()).collect();
    order.sort_by(|&a, &b| reach(&sides[a]).0.total_cmp(&reach(&sides[b]).0));
    let mut open: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for &s in &order {
        let from = reach(&sides[s]).0;
        open.retain(|&o| reach(&sides[o]).1 >= from);
        pairs.extend(open.iter().filter_map(|&o| pair(sides, [o.min(s), o.max(s)])));
        open.push(s);
    }
    pairs
}

fn pair(sides: &[Side], numbers: [usize; 2]) -> Option<Pair> {
    let [a, b] = numbers.map(|s| &sides[s]);
    if a.element == b.element || a.normal.dot(&b.normal) > -PARALLEL {
        return None;
    }
    let height = a.height.min(b.height);
    let tangent = (a.places[1] - a.places[0]) / a.length;
    let along = |p: Vec2| (p - a.places[0]).dot(&tangent);
    // the other edge runs the other way
    let [start, end] = [along(b.places[1]), along(b.places[0])];
    let (from, to) = (start.max(0.0), end.min(a.length));
    if to - from <= 1e-6 * a.length.min(b.length) {
        return None;
    }
    let place_on_b = |s: f64| (end - s) / (end - start);
    let on_a = |s: f64| a.places[0] + tangent * s;
    let on_b = |s: f64| b.places[0] + (b.places[1] - b.places[0]) * place_on_b(s);
    let touches = |s: f64| {
        let gap = (on_b(s) - on_a(s)).dot(&a.normal);
        (-DEEP * height..=NEAR * height).contains(&gap)
    };
    let part = (to - from) / PARTS as f64;
    let places = (0..PARTS).flat_map(|k| GAUSS.map(|g| from + (k as f64 + g) * part));
    let both = |s: f64| [s / a.length, place_on_b(s)];
    let points: Vec<_> = places.filter(|&s| touches(s)).map(|s| (0.5 * part, both(s))).collect();
    let middle = both(0.5 * (from + to));
    (!points.is_empty()).then_some(Pair { sides: numbers, points, middle })
}
