//! A frame with ticks and labels.

use super::colours::Colour;
use super::font::width;
use super::picture::{Anchor, Shape};
use super::scale::Ticks;

/// Height of tick labels, pixels.
pub(super) const SMALL: f64 = 13.0;
/// Height of axis titles, pixels.
pub(super) const MEDIUM: f64 = 14.5;
/// Length of ticks, pixels.
const TICK: f64 = 6.0;

/// From numbers to pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axes {
    /// Upper left and lower right corner, pixels.
    pub window: [[f64; 2]; 2],
    /// Numbers at the lower left corner.
    pub low: [f64; 2],
    /// Numbers at the upper right corner.
    pub high: [f64; 2],
}

impl Axes {
    /// Where a point is drawn.
    pub fn pixel(&self, point: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.window;
        let share = |k: usize| (point[k] - self.low[k]) / (self.high[k] - self.low[k]);
        [a[0] + share(0) * (b[0] - a[0]), b[1] - share(1) * (b[1] - a[1])]
    }

    /// Frame, ticks on all four sides, labels and titles. Tick values are divided by
    /// `factors` when they are drawn.
    pub fn shapes(&self, ticks: [&Ticks; 2], factors: [f64; 2], titles: [&str; 2]) -> Vec<Shape> {
        let [a, b] = self.window;
        let mut lines = vec![vec![a, [b[0], a[1]], b, [a[0], b[1]], a]];
        let mut texts = Vec::new();
        for (value, label) in ticks[0].values.iter().zip(&ticks[0].labels) {
            let x = self.pixel([value * factors[0], self.low[1]])[0];
            lines.push(vec![[x, b[1]], [x, b[1] - TICK]]);
            lines.push(vec![[x, a[1]], [x, a[1] + TICK]]);
            texts.push(text([x, b[1] + SMALL + 5.0], label, SMALL, Anchor::Middle));
        }
        for (value, label) in ticks[1].values.iter().zip(&ticks[1].labels) {
            let y = self.pixel([self.low[0], value * factors[1]])[1];
            lines.push(vec![[a[0], y], [a[0] + TICK, y]]);
            lines.push(vec![[b[0], y], [b[0] - TICK, y]]);
            texts.push(text([a[0] - 7.0, y + 0.36 * SMALL], label, SMALL, Anchor::End));
        }
        let middle = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        texts.push(text(
            [middle[0], b[1] + SMALL + MEDIUM + 12.0],
            titles[0],
            MEDIUM,
            Anchor::Middle,
        ));
        texts.push(Shape::Text {
            at: [a[0] - 7.0 - widest(&ticks[1].labels) - 9.0, middle[1]],
            text: titles[1].to_owned(),
            size: MEDIUM,
            anchor: Anchor::Middle,
            turned: true,
            colour: Colour::INK,
        });
        let mut shapes = vec![Shape::Lines { lines, colour: Colour::INK, width: 1.0, dash: None }];
        shapes.append(&mut texts);
        shapes
    }
}

/// Room that tick labels and the title take left of the axes, pixels.
pub(super) fn left_margin(labels: &[String]) -> f64 {
    (7.0 + widest(labels) + 9.0 + MEDIUM + 8.0).ceil()
}

/// Room below the axes, pixels.
pub(super) const BOTTOM_MARGIN: f64 = SMALL + MEDIUM + 24.0;

pub(super) fn widest(labels: &[String]) -> f64 {
    labels.iter().map(|l| width(l, SMALL)).fold(0.0, f64::max)
}

pub(super) fn text(at: [f64; 2], text: &str, size: f64, anchor: Anchor) -> Shape {
    Shape::Text { at, text: text.to_owned(), size, anchor, turned: false, colour: Colour::INK }
}

/// `name (unit)` with a prefix before the unit or a power of ten; the unit alone without name.
pub(super) fn title(name: &str, prefix: &str, unit: &str) -> String {
    match (prefix.trim(), unit) {
        ("", "") => name.to_owned(),
        (power, unit) if name.is_empty() => format!("{power}{unit}"),
        (power, "") => format!("{name} ({power})"),
        _ => format!("{name} ({prefix}{unit})"),
    }
}
