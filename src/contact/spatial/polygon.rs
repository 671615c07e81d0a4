use super::{Frame, Point, cross, section::Section, signs::Signs};
use crate::{TOLERANCE, lanes::each};

/// Corners of a section, a face and all crossings of their edges.
const MOST: usize = 4 + 3 + 4 * 3;

/// All corners of a face, a bit each.
const ALL_OF_FACE: u32 = 0b111;

/// A convex polygon in the plane of a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polygon {
    points: [Point; MOST],
    len: usize,
}

impl Polygon {
    /// Room for one.
    #[inline(always)]
    pub fn empty() -> Self {
        Self { points: [[0.0; 2]; MOST], len: 0 }
    }

    fn push(&mut self, point: Point) {
        self.points[self.len] = point;
        self.len += 1;
    }

    pub fn points(&self) -> &[Point] {
        &self.points[..self.len]
    }

    /// Twice its area, m².
    #[inline(always)]
    pub fn double_area(&self) -> f64 {
        let points = self.points();
        let [first, rest @ ..] = points else { return 0.0 };
        rest.windows(2).map(|edge| cross(*first, edge[0], edge[1])).sum()
    }

    /// Becomes what a section and a face have in common, if that has three corners at least;
    /// whether it has.
    #[inline(always)]
    pub fn intersect(&mut self, section: &Section, frame: &Frame, signs: Signs) -> bool {
        if signs.corners() < 3 {
            return false;
        }
        self.len = 0;
        if signs.face_inside == ALL_OF_FACE {
            frame.corners.iter().for_each(|&corner| self.push(corner));
            return true;
        }
        for i in (0..section.len).filter(|i| signs.section_inside & 1 << i != 0) {
            self.push(section.point(i));
        }
        if self.len == section.len {
            return true;
        }
        for j in (0..3).filter(|j| signs.face_inside & 1 << j != 0) {
            self.push(frame.corners[j]);
        }
        for i in 0..section.len {
            for j in (0..3).filter(|j| signs.crossings & 1 << (4 * j + i) != 0) {
                self.push(crossing(section, i, &frame.corners, j));
            }
        }
        self.put_in_order();
        true
    }

    /// Sorts the corners counter-clockwise around the lowest one.
    fn put_in_order(&mut self) {
        let points = &mut self.points[..self.len];
        for i in 1..points.len() {
            if points[i][1] < points[0][1] {
                points.swap(0, i);
            }
        }
        let mut slopes = [0.0; MOST];
        let [u, v] = points[0];
        for (slope, point) in slopes.iter_mut().zip(&*points).skip(1) {
            let run = point[0] - u;
            let run = match run {
                _ if run.abs() >= TOLERANCE => run,
                _ if run < 0.0 => run - TOLERANCE,
                _ => run + TOLERANCE,
            };
            *slope = (point[1] - v + TOLERANCE) / run;
        }
        for i in 1..points.len() {
            for j in i + 1..points.len() {
                let (own, other) = (slopes[i], slopes[j]);
                let comes_later = if own >= 0.0 {
                    other >= 0.0 && other < own
                } else {
                    other >= 0.0 || other < own
                };
                if comes_later {
                    slopes.swap(i, j);
                    points.swap(i, j);
                }
            }
        }
    }
}

/// Where edge `j` of a face crosses edge `i` of a section.
#[inline(always)]
fn crossing(section: &Section, i: usize, face: &[Point; 3], j: usize) -> Point {
    let (from, to) = (section.point(i), section.point((i + 1) % 4));
    let (p, q) = (face[j], face[(j + 1) % 3]);
    let (start, end) = (cross(from, to, p), cross(from, to, q));
    let difference = (start - end).abs();
    let weight = if difference < TOLERANCE { 0.5 } else { (start / difference).abs() };
    each!(2, |k| (1.0 - weight) * p[k] + weight * q[k])
}
