//! Joints as lines, coloured by how they failed, and their legend.

use super::axes::{Axes, SMALL, text};
use super::colours::Colour;
use super::contour::{ContourOptions, JointLines};
use super::font::width;
use super::picture::{Anchor, Shape};
use crate::results::{Frame, Joint, JointState};

const TENSION: Colour = Colour([0xe0, 0x00, 0x8c]);
const MIXED: Colour = Colour([0xff, 0x8c, 0x00]);
const SHEAR: Colour = Colour([0x00, 0x00, 0x00]);
const UNKNOWN: Colour = Colour([0x8b, 0x45, 0x13]);
const SOFTENING: Colour = Colour([0x77, 0x77, 0x77]);

/// What the legend of joints says: colour, width, words.
pub(super) type Legend = Vec<(Colour, f64, String)>;

pub(super) fn joint_lines(
    frame: &Frame,
    options: &ContourOptions,
    axes: &Axes,
    shapes: &mut Vec<Shape>,
) -> Legend {
    let ends = |joint: &Joint| -> Vec<[f64; 2]> {
        let moved = joint.ends.iter().zip(&joint.displacement);
        let more = options.deformation - 1.0;
        moved.map(|(x, u)| axes.pixel([x[0] + more * u[0], x[1] + more * u[1]])).collect()
    };
    let lines = |chosen: &dyn Fn(&Joint) -> bool| -> Vec<Vec<[f64; 2]>> {
        frame.joints.iter().filter(|j| chosen(j)).map(ends).collect()
    };
    let mut legend = Legend::new();
    let whole = lines(&|j| {
        j.state != JointState::Broken && j.set.is_some_and(|s| options.joint_sets.contains(&s))
    });
    if !whole.is_empty() {
        let colour = Colour([0x33; 3]);
        shapes.push(Shape::Lines { lines: whole, colour, width: 0.8, dash: None });
    }
    if options.joints == JointLines::Damaged {
        let softening = lines(&|j| j.state == JointState::Softening);
        if !softening.is_empty() {
            legend.push((SOFTENING, 1.6, format!("{} softening", softening.len())));
            let (colour, width) = (SOFTENING, 1.6);
            shapes.push(Shape::Lines { lines: softening, colour, width, dash: None });
        }
    }
    if options.joints != JointLines::None {
        let broken = |j: &Joint| j.state == JointState::Broken;
        let all = lines(&broken);
        if !all.is_empty() {
            let colour = Colour::WHITE;
            shapes.push(Shape::Lines { lines: all, colour, width: 4.2, dash: None });
        }
        type Mode = fn(Option<f64>) -> bool;
        let modes: [(&str, Colour, Mode); 4] = [
            ("broken in tension", TENSION, |m| m == Some(1.0)),
            ("broken in tension and shear", MIXED, |m| m.is_some_and(|m| m != 1.0 && m != 2.0)),
            ("broken in shear", SHEAR, |m| m == Some(2.0)),
            ("broken", UNKNOWN, |m| m.is_none()),
        ];
        for (name, colour, of_mode) in modes {
            let lines = lines(&|j| broken(j) && of_mode(j.mode));
            if !lines.is_empty() {
                legend.push((colour, 2.4, format!("{} {name}", lines.len())));
                shapes.push(Shape::Lines { lines, colour, width: 2.4, dash: None });
            }
        }
    }
    legend
}

/// The legend in as many rows as it needs from `y` on, and where it ends.
pub(super) fn legend_shapes(
    legend: &Legend,
    axes: &Axes,
    mut y: f64,
    room: f64,
) -> (Vec<Shape>, f64) {
    let left = axes.window[0][0];
    let mut shapes = vec![text([left, y + 0.36 * SMALL], "Joints:", SMALL, Anchor::Start)];
    let indented = left + width("Joints:", SMALL) + 12.0;
    let mut x = indented;
    for (colour, line, words) in legend {
        let wide = 33.0 + width(words, SMALL);
        if x > indented && x + wide > room - 10.0 {
            x = indented;
            y += SMALL + 8.0;
        }
        let lines = vec![vec![[x, y], [x + 26.0, y]]];
        shapes.push(Shape::Lines { lines, colour: *colour, width: *line, dash: None });
        shapes.push(text([x + 33.0, y + 0.36 * SMALL], words, SMALL, Anchor::Start));
        x += wide + 20.0;
    }
    (shapes, y + SMALL + 10.0)
}
