use super::{Frame, Point, cross, section::Section};
use crate::TOLERANCE;

/// Corners of a section, a face and all crossings of their edges.
const MOST: usize = 4 + 3 + 4 * 3;

/// A convex polygon in the plane of a face.
#[derive(Debug, Clone, Copy)]
pub(super) struct Polygon {
    points: [Point; MOST],
    len: usize,
}

impl Polygon {
    fn empty() -> Self {
        Self { points: [[0.0; 2]; MOST], len: 0 }
    }

    fn of(points: &[Point]) -> Self {
        let mut polygon = Self::empty();
        points.iter().for_each(|&point| polygon.push(point));
        polygon
    }

    fn push(&mut self, point: Point) {
        self.points[self.len] = point;
        self.len += 1;
    }

    pub fn points(&self) -> &[Point] {
        &self.points[..self.len]
    }

    /// What a section and a face have in common, if that has three corners at least.
    pub fn common(section: &Section, frame: &Frame) -> Option<Self> {
        let (cut, face) = (section.points(), &frame.corners);
        let count = cut.len();
        let next = |i: usize| if i + 1 == count { 0 } else { i + 1 };
        // of_cut[j][i]: point i of the cut from edge j of the face, and the other way round
        let mut of_cut = [[0.0; 4]; 3];
        let mut of_face = [[0.0; 3]; 4];
        for i in 0..count {
            for j in 0..3 {
                of_cut[j][i] = cross(face[j], face[(j + 1) % 3], cut[i]);
                of_face[i][j] = cross(cut[i], cut[next(i)], face[j]);
            }
        }
        let cut_is_inside = |i: usize| (0..3).all(|j| of_cut[j][i] >= 0.0);
        let face_is_inside = |j: usize| (0..count).all(|i| of_face[i][j] >= 0.0);
        if (0..3).all(face_is_inside) {
            return Some(Self::of(face));
        }
        if (0..count).all(cut_is_inside) {
            return Some(Self::of(cut));
        }
        let mut polygon = Self::empty();
        (0..count).filter(|&i| cut_is_inside(i)).for_each(|i| polygon.push(cut[i]));
        (0..3).filter(|&j| face_is_inside(j)).for_each(|j| polygon.push(face[j]));
        for i in 0..count {
            for j in 0..3 {
                let k = (j + 1) % 3;
                let (start, end) = (of_face[i][j], of_face[i][k]);
                if changes_sign(start, end) && changes_sign(of_cut[j][i], of_cut[j][next(i)]) {
                    let difference = (start - end).abs();
                    let weight =
                        if difference < TOLERANCE { 0.5 } else { (start / difference).abs() };
                    polygon.push([0, 1].map(|c| (1.0 - weight) * face[j][c] + weight * face[k][c]));
                }
            }
        }
        if polygon.len < 3 {
            return None;
        }
        polygon.put_in_order();
        Some(polygon)
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

/// Whether one is above and the other below 0 by more than the tolerance.
fn changes_sign(a: f64, b: f64) -> bool {
    a > TOLERANCE && b < -TOLERANCE || a < -TOLERANCE && b > TOLERANCE
}
