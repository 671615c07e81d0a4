//! Contact detection: a linear sweep over cells (spec `y2d3d.md` E.2).
//!
//! The order in which pairs are found decides the order of the couple lists
//! and with it the rounding of force sums, so the sweep visits rows and cells
//! in the original's order: rows by their highest element first, cells of a
//! row by their lowest element, elements of a cell from the highest down.

use super::{bonds::Bonds, couples::CoupleList};
use crate::{
    TOLERANCE,
    mechanics::Vec2,
    scene::{ContactSelection, Elements, Material, Nodes},
};

/// Cells farther out than this count as this one, so that their neighbours have numbers, too.
const OUTERMOST_CELL: f64 = 4e18;

/// Bounding circle of an element that takes part.
#[derive(Debug, Clone, Copy)]
struct Circle {
    element: u32,
    tag: i32,
    centre: Vec2,
    radius: f64,
    cell: [i64; 2],
}

/// The circles of a row or of a cell, and the element whose number decides
/// when it is visited.
#[derive(Debug, Clone, Copy)]
struct Span {
    key: u32,
    start: usize,
    end: usize,
}

/// What detection looks at.
#[derive(Debug, Clone, Copy)]
pub struct Participants<'a> {
    /// Nodes with their current coordinates.
    pub nodes: &'a Nodes<2>,
    /// Materials, which say what kind an element is.
    pub materials: &'a [Material],
    /// Buffer around elements, m.
    pub buffer: f64,
    /// Which triangles take part.
    pub selection: ContactSelection,
    /// Joints that keep triangles from becoming couples.
    pub bonds: Option<Bonds<'a>>,
}

/// The sweep with its buffers, reused from one detection to the next.
#[derive(Debug, Clone, Default)]
pub struct Detector {
    circles: Vec<Circle>,
    /// Rows by ascending y cell.
    rows: Vec<Span>,
    /// Indices of rows in the order of their visits.
    visits: Vec<u32>,
    /// Cells of the row being swept in the order of their visits.
    cells: Vec<Span>,
}

impl Detector {
    /// Updates the couple list: pairs that come within the buffer are added,
    /// couples that left it are removed.
    pub fn update(
        &mut self,
        scene: &Participants<'_>,
        elements: &mut Elements,
        couples: &mut CoupleList,
    ) {
        if scene.selection != ContactSelection::Flagged {
            tag_boundary_elements(scene, elements);
        }
        self.load(scene, elements);
        self.sort_into_cells(scene.buffer);
        couples.resize(elements.len());
        for visit in 0..self.visits.len() {
            let row = self.visits[visit] as usize;
            self.list_cells(row);
            self.sweep_row(row, scene, elements, couples);
        }
    }

    fn load(&mut self, scene: &Participants<'_>, elements: &Elements) {
        self.circles.clear();
        for element in 0..elements.len() {
            if !takes_part(scene, elements, element) {
                continue;
            }
            let tag = elements.contact_tag[element];
            let is_selected = match scene.selection {
                ContactSelection::All => true,
                ContactSelection::Tagged => tag > 0,
                ContactSelection::Flagged => is_flagged(scene, elements, element, |f| f > 0),
            };
            if is_selected {
                let corners = elements.corners::<3>(element).map(|n| scene.nodes.current[n]);
                self.circles.push(Circle::around(element as u32, tag, &corners));
            }
        }
    }

    fn sort_into_cells(&mut self, buffer: f64) {
        let mut largest = self.circles.iter().fold(0.0, |r: f64, c| r.max(c.radius));
        if largest < TOLERANCE {
            largest = 1e15;
        }
        let width = 2.0 * (largest + buffer);
        for circle in &mut self.circles {
            // truncation toward zero, so that the cells at the axes are twice as wide
            let cell = |x: f64| (x / width).clamp(-OUTERMOST_CELL, OUTERMOST_CELL) as i64;
            circle.cell = [cell(circle.centre.x), cell(circle.centre.y)];
        }
        self.circles.sort_unstable_by_key(|c| (c.cell[1], c.cell[0], std::cmp::Reverse(c.element)));
        self.rows.clear();
        let mut start = 0;
        for row in self.circles.chunk_by(|a, b| a.cell[1] == b.cell[1]) {
            let highest = row.iter().map(|c| c.element).max().unwrap_or(0);
            self.rows.push(Span { key: highest, start, end: start + row.len() });
            start += row.len();
        }
        self.visits.clear();
        self.visits.extend(0..self.rows.len() as u32);
        self.visits.sort_unstable_by_key(|&r| std::cmp::Reverse(self.rows[r as usize].key));
    }

    fn list_cells(&mut self, row: usize) {
        let row = self.rows[row];
        self.cells.clear();
        let mut start = row.start;
        for cell in self.circles[row.start..row.end].chunk_by(|a, b| a.cell[0] == b.cell[0]) {
            let lowest = cell.last().map_or(0, |c| c.element);
            self.cells.push(Span { key: lowest, start, end: start + cell.len() });
            start += cell.len();
        }
        self.cells.sort_unstable_by_key(|c| c.key);
    }

    fn sweep_row(
        &self,
        index: usize,
        scene: &Participants<'_>,
        elements: &Elements,
        couples: &mut CoupleList,
    ) {
        let row = self.rows[index];
        let y = self.circles[row.start].cell[1];
        let below = index
            .checked_sub(1)
            .map(|b| self.rows[b])
            .filter(|b| self.circles[b.start].cell[1] == y - 1);
        let in_below = |x: i64| below.map_or(&[][..], |b| self.cell(b, x));
        for cell in &self.cells {
            let own = &self.circles[cell.start..cell.end];
            let x = own[0].cell[0];
            let around = [self.cell(row, x - 1), in_below(x + 1), in_below(x), in_below(x - 1)];
            for (i, a) in own.iter().enumerate() {
                for b in own[i + 1..].iter().chain(around.into_iter().flatten()) {
                    examine(a, b, scene, elements, couples);
                }
            }
        }
    }

    /// Circles of cell `x` of a row, highest element first.
    fn cell(&self, row: Span, x: i64) -> &[Circle] {
        let circles = &self.circles[row.start..row.end];
        let start = circles.partition_point(|c| c.cell[0] < x);
        let len = circles[start..].partition_point(|c| c.cell[0] == x);
        &circles[start..start + len]
    }
}

impl Circle {
    fn around(element: u32, tag: i32, corners: &[Vec2; 3]) -> Self {
        let sum = corners[0] + corners[1] + corners[2];
        let centre = Vec2::new(sum.x / 3.0, sum.y / 3.0);
        let squared =
            corners.iter().fold(0.0, |r: f64, corner| r.max(distance_squared(centre, *corner)));
        Self { element, tag, centre, radius: squared.sqrt(), cell: [0; 2] }
    }
}

fn distance_squared(a: Vec2, b: Vec2) -> f64 {
    let d = a - b;
    d.x * d.x + d.y * d.y
}

/// Adds or removes the couple of two elements as their distance asks.
fn examine(
    a: &Circle,
    b: &Circle,
    scene: &Participants<'_>,
    elements: &Elements,
    couples: &mut CoupleList,
) {
    if scene.bonds.is_some_and(|bonds| bonds.exclude(elements, a.element, b.element)) {
        return;
    }
    if scene.selection == ContactSelection::Tagged && a.tag == b.tag {
        return;
    }
    let (contactor, target) = if a.element > b.element { (a, b) } else { (b, a) };
    let distance = distance_squared(contactor.centre, target.centre);
    let reach = contactor.radius + target.radius + scene.buffer;
    match couples.find(contactor.element, target.element) {
        Some(slot) if distance > reach * reach => couples.remove(contactor.element, slot),
        Some(_) => {}
        None if distance < reach * reach => {
            couples.insert(contactor.element, target.element);
        }
        None => {}
    }
}

/// Gives every element with a node flagged 1 its own tag. Tags are never
/// taken back.
fn tag_boundary_elements(scene: &Participants<'_>, elements: &mut Elements) {
    for element in 0..elements.len() {
        if takes_part(scene, elements, element)
            && is_flagged(scene, elements, element, |flag| flag == 1)
        {
            elements.contact_tag[element] = element as i32 + 1;
        }
    }
}

/// Whether a corner of the triangle has a flag that `counts`.
fn is_flagged(
    scene: &Participants<'_>,
    elements: &Elements,
    element: usize,
    counts: impl Fn(i32) -> bool,
) -> bool {
    elements.corners::<3>(element).into_iter().any(|n| counts(scene.nodes.boundary_flag[n]))
}

fn takes_part(scene: &Participants<'_>, elements: &Elements, element: usize) -> bool {
    usize::try_from(elements.property[element])
        .ok()
        .and_then(|property| scene.materials.get(property))
        .is_some_and(|material| material.kind.takes_part_in_contact())
}
