//! The linear sweep over cells that finds pairs of elements close to each other
//! (spec `y2d3d.md` E.2), in the plane (one layer of cells) and in space.
//!
//! The order in which pairs are found decides the order of the couple lists
//! and with it the rounding of force sums, so the sweep visits cells in the
//! original's order: layers by their lowest element first, rows of a layer by
//! their highest element first, cells of a row by their lowest element,
//! elements of a cell from the highest down.

use super::couples::CoupleList;
use crate::TOLERANCE;
use nalgebra::SVector;
use std::cmp::Reverse;

/// Cells farther out than this count as this one, so that their neighbours have numbers, too.
const OUTERMOST_CELL: f64 = 4e18;

/// Neighbouring cells that a cell is compared with.
const NEIGHBOURS: usize = 13;

/// Bounding ball (in the plane, circle) of an element that takes part.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ball<const D: usize> {
    pub element: u32,
    pub tag: i32,
    pub centre: SVector<f64, D>,
    pub radius: f64,
    cell: [i64; D],
}

impl<const D: usize> Ball<D> {
    pub fn new(element: u32, tag: i32, centre: SVector<f64, D>, radius: f64) -> Self {
        Self { element, tag, centre, radius, cell: [0; D] }
    }

    /// Number of the cell along x, y or z; 0 along a dimension that is not there.
    fn cell_along(&self, axis: usize) -> i64 {
        self.cell.get(axis).copied().unwrap_or(0)
    }
}

/// The squared distance of two points, m².
pub(super) fn distance_squared<const D: usize>(a: &SVector<f64, D>, b: &SVector<f64, D>) -> f64 {
    let d = a - b;
    (1..D).fold(d[0] * d[0], |sum, k| sum + d[k] * d[k])
}

/// The balls of a layer, row or cell, and the element whose number decides when it is visited.
#[derive(Debug, Clone, Copy)]
struct Span {
    /// z, y or x of its cells.
    cell: i64,
    key: u32,
    start: usize,
    end: usize,
}

/// The sweep with its buffers, reused from one detection to the next.
#[derive(Debug, Clone)]
pub(super) struct Sweep<const D: usize> {
    pub balls: Vec<Ball<D>>,
    /// Lowest element that takes no part: it counts as lying at the origin when layers are put
    /// in order.
    pub first_idle: Option<u32>,
    /// By ascending z, and indices of them in the order of visits.
    layers: Vec<Span>,
    order: Vec<u32>,
    /// Rows of the layer being swept, by ascending y, and indices of them in the order of visits.
    rows: Vec<Span>,
    visits: Vec<u32>,
    /// Rows of the layer below.
    rows_below: Vec<Span>,
    /// Cells of the row being swept in the order of their visits.
    cells: Vec<Span>,
}

impl<const D: usize> Default for Sweep<D> {
    fn default() -> Self {
        Self {
            balls: Vec::new(),
            first_idle: None,
            layers: Vec::new(),
            order: Vec::new(),
            rows: Vec::new(),
            visits: Vec::new(),
            rows_below: Vec::new(),
            cells: Vec::new(),
        }
    }
}

impl<const D: usize> Sweep<D> {
    /// Calls `examine` for all pairs of balls in neighbouring cells, which are as wide as the
    /// largest ball with half the buffer on each side.
    pub fn pairs(&mut self, buffer: f64, mut examine: impl FnMut(&Ball<D>, &Ball<D>)) {
        self.sort_into_cells(buffer);
        let Self { layers, order, .. } = self;
        order.clear();
        order.extend(0..layers.len() as u32);
        order.sort_unstable_by_key(|&layer| layers[layer as usize].key);
        for place in 0..self.order.len() {
            self.list_rows(self.order[place] as usize);
            for visit in 0..self.visits.len() {
                let row = self.visits[visit] as usize;
                self.list_cells(row);
                self.sweep_row(row, &mut examine);
            }
        }
    }

    fn sort_into_cells(&mut self, buffer: f64) {
        let mut largest = self.balls.iter().fold(0.0, |r: f64, ball| r.max(ball.radius));
        if largest < TOLERANCE {
            largest = 1e15;
        }
        let width = 2.0 * (largest + buffer);
        for ball in &mut self.balls {
            for (cell, x) in ball.cell.iter_mut().zip(ball.centre.iter()) {
                // truncation toward zero, so that the cells at the axes are twice as wide
                *cell = (x / width).clamp(-OUTERMOST_CELL, OUTERMOST_CELL) as i64;
            }
        }
        self.balls.sort_unstable_by_key(|ball| {
            (ball.cell_along(2), ball.cell_along(1), ball.cell[0], Reverse(ball.element))
        });
        self.layers.clear();
        spans(&self.balls, 0..self.balls.len(), 2, |ball| ball.element, u32::min, &mut self.layers);
        if let Some(idle) = self.first_idle {
            for layer in self.layers.iter_mut().filter(|layer| layer.cell == 0) {
                layer.key = layer.key.min(idle);
            }
        }
    }

    fn list_rows(&mut self, layer: usize) {
        let Self { balls, layers, rows, rows_below, visits, .. } = self;
        let list = |layer: Span, rows: &mut Vec<Span>| {
            spans(balls, layer.start..layer.end, 1, |ball| ball.element, u32::max, rows);
        };
        rows.clear();
        rows_below.clear();
        list(layers[layer], rows);
        let z = layers[layer].cell;
        if let Some(below) = layer.checked_sub(1).map(|b| layers[b]).filter(|b| b.cell == z - 1) {
            list(below, rows_below);
        }
        visits.clear();
        visits.extend(0..rows.len() as u32);
        visits.sort_unstable_by_key(|&row| Reverse(rows[row as usize].key));
    }

    fn list_cells(&mut self, row: usize) {
        let row = self.rows[row];
        self.cells.clear();
        let cells = &mut self.cells;
        spans(&self.balls, row.start..row.end, 0, |ball| ball.element, u32::min, cells);
        self.cells.sort_unstable_by_key(|cell| cell.key);
    }

    fn sweep_row(&self, index: usize, examine: &mut impl FnMut(&Ball<D>, &Ball<D>)) {
        let row = self.rows[index];
        let y = row.cell;
        let before =
            index.checked_sub(1).map(|before| self.rows[before]).filter(|row| row.cell == y - 1);
        let [below, same, above] = [y - 1, y, y + 1].map(|y| {
            let found = self.rows_below.binary_search_by_key(&y, |row| row.cell);
            found.ok().map(|row| self.rows_below[row])
        });
        let others = [below, same, above, before];
        for cell in &self.cells {
            let x = cell.cell;
            let mut around = [&[][..]; NEIGHBOURS];
            let mut count = 0;
            let mut add = |row: Option<Span>, x: i64| {
                let balls = row.map_or(&[][..], |row| self.cell(row, x));
                if !balls.is_empty() {
                    around[count] = balls;
                    count += 1;
                }
            };
            add(Some(row), x - 1);
            for x in [x + 1, x, x - 1] {
                others.iter().for_each(|&row| add(row, x));
            }
            let own = &self.balls[cell.start..cell.end];
            for (i, a) in own.iter().enumerate() {
                for b in own[i + 1..].iter().chain(around[..count].iter().copied().flatten()) {
                    examine(a, b);
                }
            }
        }
    }

    /// Balls of cell `x` of a row, highest element first.
    fn cell(&self, row: Span, x: i64) -> &[Ball<D>] {
        let balls = &self.balls[row.start..row.end];
        let start = balls.partition_point(|ball| ball.cell[0] < x);
        let len = balls[start..].partition_point(|ball| ball.cell[0] == x);
        &balls[start..start + len]
    }
}

/// Appends the spans of balls with the same cell along one axis.
fn spans<const D: usize>(
    balls: &[Ball<D>],
    range: std::ops::Range<usize>,
    axis: usize,
    number: impl Fn(&Ball<D>) -> u32,
    choose: impl Fn(u32, u32) -> u32,
    into: &mut Vec<Span>,
) {
    let mut start = range.start;
    for span in balls[range].chunk_by(|a, b| a.cell_along(axis) == b.cell_along(axis)) {
        let key = span.iter().map(&number).reduce(&choose).unwrap_or(0);
        into.push(Span { cell: span[0].cell_along(axis), key, start, end: start + span.len() });
        start += span.len();
    }
}

/// Adds or removes the couple of two elements as their distance asks; the slot of a new one.
/// `find` gives the slot of the couple of a contactor and a target that was there before the sweep,
/// which examines no pair twice.
#[inline(always)]
pub(super) fn couple_or_part<const D: usize, S: Copy + Default>(
    a: &Ball<D>,
    b: &Ball<D>,
    buffer: f64,
    couples: &mut CoupleList<S>,
    find: impl FnOnce(&CoupleList<S>, u32, u32) -> Option<u32>,
) -> Option<u32> {
    let (contactor, target) = if a.element > b.element { (a, b) } else { (b, a) };
    let distance = distance_squared(&contactor.centre, &target.centre);
    let reach = contactor.radius + target.radius + buffer;
    match find(couples, contactor.element, target.element) {
        Some(slot) if distance > reach * reach => {
            couples.remove(contactor.element, slot);
            None
        }
        None if distance < reach * reach => Some(couples.insert(contactor.element, target.element)),
        _ => None,
    }
}
