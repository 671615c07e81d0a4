//! Curves: columns of tables against each other.

use super::axes::{Axes, BOTTOM_MARGIN, SMALL, left_margin, text, title};
use super::colours::{CURVES, Colour};
use super::font::width;
use super::picture::{Anchor, Picture, Shape};
use super::scale::{Ticks, prefix};
use crate::error::PostError;

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Its points; NaN breaks it.
    pub points: Vec<[f64; 2]>,
}

/// How a picture of curves looks.
#[derive(Debug, Clone, PartialEq)]
pub struct CurveOptions {
    /// Title; empty for none.
    pub title: String,
    /// Names of the axes, units in brackets behind them: `time (s)`.
    pub labels: [String; 2],
    /// What is shown of either axis; without it everything.
    pub ranges: [Option<[f64; 2]>; 2],
    /// Whether points are marked.
    pub markers: bool,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
}

/// Dashes that tell curves of the same colour apart.
const DASHES: [Option<[f64; 2]>; 3] = [None, Some([8.0, 4.0]), Some([2.0, 3.0])];

/// How numbers are spread along an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// By their logarithms; numbers that are not above 0 are left out.
    Logarithmic,
}

/// Draws curves.
///
/// # Errors
/// If no curve has a finite point, or the options make no sense.
pub fn curves(curves: &[Curve], options: &CurveOptions) -> Result<Picture, PostError> {
    draw(curves, options, [Scale::Linear; 2])
}

/// Draws curves on axes of which one or both may be logarithmic.
///
/// # Errors
/// If no curve has a point that can be shown, or the options make no sense.
pub fn curves_on(
    scales: [Scale; 2],
    curves: &[Curve],
    options: &CurveOptions,
) -> Result<Picture, PostError> {
    let log = |k: usize, x: f64| match scales[k] {
        Scale::Linear => x,
        Scale::Logarithmic if x > 0.0 => x.log10(),
        Scale::Logarithmic => f64::NAN,
    };
    let drawn: Vec<Curve> = curves
        .iter()
        .map(|curve| Curve {
            name: curve.name.clone(),
            points: curve.points.iter().map(|&[x, y]| [log(0, x), log(1, y)]).collect(),
        })
        .collect();
    let ranges = [0, 1].map(|k| options.ranges[k].map(|range| range.map(|x| log(k, x))));
    draw(&drawn, &CurveOptions { ranges, ..options.clone() }, scales)
}

/// Draws curves whose points are logarithms already where an axis is logarithmic.
fn draw(
    curves: &[Curve],
    options: &CurveOptions,
    scales: [Scale; 2],
) -> Result<Picture, PostError> {
    let [wide, tall] = options.size;
    if !(300..=8000).contains(&wide) || !(200..=8000).contains(&tall) {
        let expected = "expected 300 x 200 to 8000 x 8000 pixels";
        return Err(PostError::words("the size", format!("{wide} x {tall}"), expected));
    }
    let ranges = [0, 1].map(|k| range(curves, options, k));
    let [x, y] = ranges;
    let (x, y) = (x?, y?);
    let scaled = [(0, x), (1, y)].map(|(k, [low, high])| {
        if scales[k] == Scale::Logarithmic {
            return (options.labels[k].clone(), 1.0);
        }
        let (name, unit) = split_unit(&options.labels[k]);
        let (prefix, factor) = prefix(low.abs().max(high.abs()), unit);
        (title(name, &prefix, unit), factor)
    });
    let [(x_title, x_factor), (y_title, y_factor)] = &scaled;
    let top = if options.title.is_empty() { 20.0 } else { 52.0 };
    let bottom = f64::from(tall) - BOTTOM_MARGIN;
    let wanted = (((bottom - top) / 55.0) as usize).max(2);
    let ticks = |scale: Scale, [low, high]: [f64; 2], factor: f64, wanted: usize| match scale {
        Scale::Linear => Ticks::new(low / factor, high / factor, wanted),
        Scale::Logarithmic => Ticks::logarithmic(low, high, wanted),
    };
    let y_ticks = ticks(scales[1], y, *y_factor, wanted);
    let left = left_margin(&y_ticks.labels);
    let right = f64::from(wide) - 24.0;
    let x_ticks = ticks(scales[0], x, *x_factor, ((right - left) / 100.0) as usize);
    let axes =
        Axes { window: [[left, top], [right, bottom]], low: [x[0], y[0]], high: [x[1], y[1]] };

    let mut shapes = vec![grid(&axes, &x_ticks, &y_ticks, [*x_factor, *y_factor])];
    let mut inside = Vec::new();
    for (index, curve) in curves.iter().enumerate() {
        inside.extend(curve_shapes(curve, &axes, look(index), options.markers));
    }
    shapes.push(Shape::Clipped { window: axes.window, shapes: inside });
    shapes.extend(axes.shapes([&x_ticks, &y_ticks], [*x_factor, *y_factor], [x_title, y_title]));
    if !options.title.is_empty() {
        shapes.push(text([left, 34.0], &options.title, 18.0, Anchor::Start));
    }
    if curves.len() > 1 {
        shapes.extend(legend(curves, &axes));
    }
    Ok(Picture { width: wide, height: tall, shapes })
}

/// Colour and dash of a curve.
fn look(index: usize) -> (Colour, Option<[f64; 2]>) {
    let colour = CURVES[index % CURVES.len()];
    (colour, DASHES[(index / CURVES.len()) % DASHES.len()])
}

/// What is shown of axis `k`.
fn range(curves: &[Curve], options: &CurveOptions, k: usize) -> Result<[f64; 2], PostError> {
    if let Some([low, high]) = options.ranges[k] {
        if low < high && low.is_finite() && high.is_finite() {
            return Ok([low, high]);
        }
        let found = format!("{low}:{high}");
        return Err(PostError::words("the range", found, "expected LOW:HIGH, smaller first"));
    }
    let points = curves.iter().flat_map(|c| &c.points);
    let finite = points.filter(|p| p.iter().all(|x| x.is_finite())).map(|p| p[k]);
    let (low, high) =
        finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return Err(PostError::Nothing("the curves have no finite point".to_owned()));
    }
    let span = high - low;
    let size = low.abs().max(high.abs());
    if span <= 1e-12 * size || span == 0.0 {
        let around = if size > 0.0 { 0.1 * size } else { 1.0 };
        return Ok([low - around, high + around]);
    }
    // curves along x fill the width; along y they keep off the frame
    let margin = if k == 0 { 0.0 } else { 0.05 * span };
    Ok([low - margin, high + margin])
}

/// `time (s)` as name and unit.
fn split_unit(label: &str) -> (&str, &str) {
    let label = label.trim();
    if let Some(unit) = label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        return ("", unit);
    }
    let inner = label.strip_suffix(')').and_then(|rest| rest.rsplit_once(" ("));
    inner.unwrap_or((label, ""))
}

fn grid(axes: &Axes, x: &Ticks, y: &Ticks, factors: [f64; 2]) -> Shape {
    let [a, b] = axes.window;
    let mut lines = Vec::new();
    for value in &x.values {
        let at = axes.pixel([value * factors[0], axes.low[1]])[0];
        lines.push(vec![[at, a[1]], [at, b[1]]]);
    }
    for value in &y.values {
        let at = axes.pixel([axes.low[0], value * factors[1]])[1];
        lines.push(vec![[a[0], at], [b[0], at]]);
    }
    Shape::Lines { lines, colour: Colour([0xe4; 3]), width: 0.8, dash: None }
}

fn curve_shapes(
    curve: &Curve,
    axes: &Axes,
    (colour, dash): (Colour, Option<[f64; 2]>),
    markers: bool,
) -> Vec<Shape> {
    let is_shown = |p: &[f64; 2]| p.iter().all(|x| x.is_finite());
    let lines: Vec<Vec<[f64; 2]>> = curve
        .points
        .split(|p| !is_shown(p))
        .filter(|part| !part.is_empty())
        .map(|part| part.iter().map(|p| near(axes, axes.pixel(*p))).collect())
        .collect();
    let mut shapes = Vec::new();
    if markers {
        let parts = curve.points.split(|p| !is_shown(p));
        // points that no line leads to stand out
        let rings = parts.flat_map(|part| {
            let size = if part.len() == 1 { 6.0 } else { 3.5 };
            part.iter().map(move |p| diamond(axes.pixel(*p), size))
        });
        shapes.push(Shape::Polygons { rings: rings.collect(), colour, seam: 0.0 });
    }
    shapes.push(Shape::Lines { lines, colour, width: 1.7, dash });
    shapes
}

/// A point far outside of the window comes nearer, so that no backend stumbles over it.
fn near(axes: &Axes, [x, y]: [f64; 2]) -> [f64; 2] {
    let [a, b] = axes.window;
    let far = 20_000.0;
    [x.clamp(a[0] - far, b[0] + far), y.clamp(a[1] - far, b[1] + far)]
}

fn diamond([x, y]: [f64; 2], size: f64) -> Vec<[f64; 2]> {
    vec![[x - size, y], [x, y - size], [x + size, y], [x, y + size]]
}

/// Names of the curves in the corner where fewest points lie.
fn legend(curves: &[Curve], axes: &Axes) -> Vec<Shape> {
    let line = SMALL + 6.0;
    let longest = curves.iter().map(|c| width(&c.name, SMALL)).fold(0.0, f64::max);
    let (wide, tall) = (longest + 34.0 + 20.0, line * curves.len() as f64 + 10.0);
    let [a, b] = axes.window;
    let corners = [
        [b[0] - wide - 12.0, a[1] + 12.0],
        [a[0] + 12.0, a[1] + 12.0],
        [b[0] - wide - 12.0, b[1] - tall - 12.0],
        [a[0] + 12.0, b[1] - tall - 12.0],
    ];
    let covered = |corner: &[f64; 2]| {
        let points = curves.iter().flat_map(|c| c.points.windows(2));
        let hits = |pair: &[[f64; 2]]| {
            // a few places on each piece, so that long pieces count too
            (0..8).any(|i| {
                let t = f64::from(i) / 7.0;
                let [p, q] = [axes.pixel(pair[0]), axes.pixel(pair[1])];
                let (x, y) = (p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]));
                (corner[0]..=corner[0] + wide).contains(&x)
                    && (corner[1]..=corner[1] + tall).contains(&y)
            })
        };
        points.filter(|pair| hits(pair)).count()
    };
    let [x, y] = corners.into_iter().min_by_key(covered).unwrap_or(corners[0]);
    let ring = vec![[x, y], [x + wide, y], [x + wide, y + tall], [x, y + tall]];
    let mut border = ring.clone();
    border.push([x, y]);
    let mut shapes = vec![
        Shape::Polygons { rings: vec![ring], colour: Colour::WHITE, seam: 0.0 },
        Shape::Lines { lines: vec![border], colour: Colour([0xbb; 3]), width: 0.8, dash: None },
    ];
    for (index, curve) in curves.iter().enumerate() {
        let (colour, dash) = look(index);
        let middle = y + 5.0 + line * (index as f64 + 0.5);
        let lines = vec![vec![[x + 10.0, middle], [x + 36.0, middle]]];
        shapes.push(Shape::Lines { lines, colour, width: 2.0, dash });
        let at = [x + 44.0, middle + 0.36 * SMALL];
        shapes.push(text(at, &curve.name, SMALL, Anchor::Start));
    }
    shapes
}
