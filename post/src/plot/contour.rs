//! Contour pictures.

use super::axes::{Axes, BOTTOM_MARGIN, MEDIUM, SMALL, left_margin, text, title, widest};
use super::colouring::{BAR, BAR_GAP, Colouring, bar_ticks, colour_bar};
use super::colours::{Colour, ColourMap};
use super::fills::{banded, flat};
use super::font::width;
use super::joint_lines::{joint_lines, legend_shapes};
use super::outline::outline;
use super::picture::{Anchor, Picture, Shape};
use super::scale::{Ticks, prefix, short};
use super::weld::{averaged, weld};
use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::Frame;
use crate::vectors::bounds;

/// Which numbers the colours cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Range {
    /// From the smallest to the largest value.
    Full,
    /// Without the given share of values, percent, at either end: peaks at single triangles do
    /// not spoil the picture.
    Robust(f64),
    /// From one number to another, in the field's unit.
    Fixed([f64; 2]),
}

/// Which joints are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointLines {
    /// None.
    None,
    /// Broken ones, coloured by how they failed.
    Broken,
    /// Softening ones as well.
    Damaged,
}

/// How a contour picture looks.
#[derive(Debug, Clone, PartialEq)]
pub struct ContourOptions {
    /// What is shown.
    pub field: Field,
    /// Colours; without it by the field: with sign or without.
    pub map: Option<ColourMap>,
    /// Numbers that the colours cover.
    pub range: Range,
    /// Factor on displacements.
    pub deformation: f64,
    /// Whether stresses are averaged at the nodes and drawn as bands between lines of equal
    /// value. Nodal fields are always drawn so.
    pub smooth: bool,
    /// Number of bands.
    pub bands: usize,
    /// Whether the edges of all triangles are drawn.
    pub edges: bool,
    /// Whether the outline of the undeformed bodies is drawn.
    pub undeformed: bool,
    /// Which joints are drawn.
    pub joints: JointLines,
    /// Joint sets whose unbroken joints are drawn as thin lines.
    pub joint_sets: Vec<i32>,
    /// What part is shown, m: lower left and upper right corner.
    pub window: Option<[[f64; 2]; 2]>,
    /// Width of the picture, pixels.
    pub width: u32,
    /// Title; without it the field and the time.
    pub title: Option<String>,
}

impl ContourOptions {
    /// The usual look.
    #[must_use]
    pub fn new(field: Field) -> Self {
        Self {
            field,
            map: None,
            range: Range::Full,
            deformation: 1.0,
            smooth: false,
            bands: 16,
            edges: false,
            undeformed: false,
            joints: JointLines::Broken,
            joint_sets: Vec::new(),
            window: None,
            width: 1000,
            title: None,
        }
    }
}

/// Bands at most.
const MOST_BANDS: usize = 256;
/// Height of the title, pixels.
const LARGE: f64 = 18.0;
/// Least height of the axes, pixels: the colour bar needs it.
const LEAST_HEIGHT: f64 = 200.0;
/// Height of the axes at most, relative to the width of the picture.
const LARGEST_HEIGHT: f64 = 1.1;
/// Smallest and largest width of pictures, pixels.
const WIDTHS: std::ops::RangeInclusive<u32> = 300..=8000;

/// Draws a field of a frame on its deformed bodies.
///
/// # Errors
/// If the field is not in the frame, there is no triangle, or the options make no sense.
pub fn contour(frame: &Frame, options: &ContourOptions) -> Result<Picture, PostError> {
    check(options)?;
    if frame.elements.is_empty() {
        return Err(PostError::Nothing("there are no triangles to draw".to_owned()));
    }
    let values = options.field.values(frame)?;
    let colours = Colouring::new(options, &values)?;
    let initial = frame.initial();
    let points = deformed(&initial, frame, options.deformation)?;
    let layout = Layout::new(options, frame, &initial, &points, &colours)?;
    let axes = &layout.axes;
    let (classes, count) = weld(frame, &initial);

    let mut inside = Vec::new();
    let corners = match (&values, options.smooth) {
        (FieldValues::Elements(each), true) => Some(averaged(frame, each, &classes, count)),
        (FieldValues::Elements(_), false) => None,
        (FieldValues::Nodes(_), _) => Some(values.corners(frame)),
    };
    inside.extend(match &corners {
        Some(corners) => banded(frame, &points, corners, axes, &colours),
        None => flat(frame, &points, &values.of_elements(frame), axes, &colours),
    });
    let to_pixels = |lines: Vec<Vec<[f64; 2]>>| -> Vec<Vec<[f64; 2]>> {
        lines.into_iter().map(|l| l.into_iter().map(|p| axes.pixel(p)).collect()).collect()
    };
    let line = |lines, colour, width, dash| Shape::Lines { lines, colour, width, dash };
    if options.edges {
        let rings = frame.elements.iter().map(|&t| {
            let [a, b, c] = Frame::corners(t, &points);
            vec![a, b, c, a]
        });
        inside.push(line(to_pixels(rings.collect()), Colour([0x55; 3]), 0.4, None));
    }
    if options.undeformed {
        let edges = to_pixels(outline(frame, &classes, &initial));
        inside.push(line(edges, Colour([0x99; 3]), 0.9, Some([4.0, 3.0])));
    }
    let edges = to_pixels(outline(frame, &classes, &points));
    inside.push(line(edges, Colour([0x33; 3]), 0.8, None));
    let legend = joint_lines(frame, options, axes, &mut inside);

    let mut shapes = vec![Shape::Clipped { window: axes.window, shapes: inside }];
    shapes.extend(layout.shapes());
    shapes.extend(colour_bar(axes, &colours, corners.is_some()));
    shapes.extend(titles(frame, options, axes, &colours));
    let mut height = axes.window[1][1] + BOTTOM_MARGIN;
    if !legend.is_empty() {
        let (drawn, end) = legend_shapes(&legend, axes, height + 4.0, f64::from(options.width));
        shapes.extend(drawn);
        height = end;
    }
    Ok(Picture { width: options.width, height: height.ceil() as u32, shapes })
}

fn check(options: &ContourOptions) -> Result<(), PostError> {
    if !WIDTHS.contains(&options.width) {
        let expected = format!("expected {} to {} pixels", WIDTHS.start(), WIDTHS.end());
        return Err(PostError::words("the width", options.width.to_string(), expected));
    }
    if !(2..=MOST_BANDS).contains(&options.bands) {
        let found = options.bands.to_string();
        return Err(PostError::words("the number of bands", found, "expected 2 to 256"));
    }
    if !options.deformation.is_finite() {
        let found = options.deformation.to_string();
        return Err(PostError::words("the scale of deformation", found, "expected a number"));
    }
    if let Some([low, high]) = options.window
        && !(low[0] < high[0] && low[1] < high[1] && low.iter().chain(&high).all(|x| x.is_finite()))
    {
        let found = format!("{}:{},{}:{}", low[0], high[0], low[1], high[1]);
        return Err(PostError::words("the window", found, "expected X0:X1,Y0:Y1, smaller first"));
    }
    Ok(())
}

/// Places of the nodes with displacements scaled.
fn deformed(initial: &[[f64; 2]], frame: &Frame, scale: f64) -> Result<Vec<[f64; 2]>, PostError> {
    if scale == 1.0 {
        return Ok(frame.points.clone());
    }
    let moved = frame.displacement.as_ref().ok_or(PostError::MissingArray {
        array: "displacements",
        wanted: "a scale of deformation other than 1".to_owned(),
        remedy: "leave the scale away",
    })?;
    Ok(initial.iter().zip(moved).map(|(x, u)| [x[0] + scale * u[0], x[1] + scale * u[1]]).collect())
}

/// Axes of equal scale around the bodies.
struct Layout {
    axes: Axes,
    ticks: [Ticks; 2],
    prefix: String,
    factor: f64,
}

impl Layout {
    fn new(
        options: &ContourOptions,
        frame: &Frame,
        initial: &[[f64; 2]],
        points: &[[f64; 2]],
        colours: &Colouring,
    ) -> Result<Self, PostError> {
        let [mut low, mut high] = match options.window {
            Some(window) => window,
            None => {
                let used = |points: &[[f64; 2]]| -> Vec<[f64; 2]> {
                    let corners = frame.elements.iter();
                    corners.flat_map(|&t| Frame::corners(t, points)).collect()
                };
                let mut shown = used(points);
                if options.undeformed {
                    shown.extend(used(initial));
                }
                let [low, high] = bounds(&shown)?;
                let margin = 0.04 * (high[0] - low[0]).max(high[1] - low[1]);
                let margin = if margin > 0.0 { margin } else { 1.0 };
                [low.map(|x| x - margin), high.map(|x| x + margin)]
            }
        };
        let (prefix, factor) =
            prefix(low.iter().chain(&high).fold(0.0, |m: f64, x| m.max(x.abs())), "m");
        let bar_labels = bar_ticks(colours).labels;
        let room = f64::from(options.width);
        let right =
            BAR_GAP + BAR + 8.0 + widest(&bar_labels).max(width(&colours.unit(), MEDIUM)) + 14.0;
        let mut left = 70.0;
        let top = 20.0 + LARGE + SMALL + 18.0;
        let mut axes = Axes { window: [[0.0; 2]; 2], low, high };
        let mut ticks = [Ticks::new(0.0, 0.0, 0), Ticks::new(0.0, 0.0, 0)];
        // the labels decide the margin, the margin the scale and so the ticks: twice is enough
        for _ in 0..2 {
            let wide = (room - left - right).max(50.0);
            let [x, y] = [high[0] - low[0], high[1] - low[1]];
            let mut scale = wide / x;
            let mut tall = y * scale;
            if tall > LARGEST_HEIGHT * room {
                tall = LARGEST_HEIGHT * room;
                scale = tall / y;
                let more = 0.5 * (wide / scale - x);
                low[0] -= more;
                high[0] += more;
            } else if tall < LEAST_HEIGHT {
                tall = LEAST_HEIGHT;
                let more = 0.5 * (tall / scale - y);
                low[1] -= more;
                high[1] += more;
            }
            axes = Axes { window: [[left, top], [left + wide, top + tall]], low, high };
            ticks = [
                Ticks::new(low[0] / factor, high[0] / factor, (wide / 110.0) as usize),
                Ticks::new(low[1] / factor, high[1] / factor, ((tall / 80.0) as usize).max(2)),
            ];
            left = left_margin(&ticks[1].labels);
        }
        Ok(Self { axes, ticks, prefix, factor })
    }

    fn shapes(&self) -> Vec<Shape> {
        let titles = ["x", "y"].map(|name| title(name, &self.prefix, "m"));
        let [x, y] = &self.ticks;
        self.axes.shapes([x, y], [self.factor; 2], [&titles[0], &titles[1]])
    }
}

fn titles(frame: &Frame, options: &ContourOptions, axes: &Axes, colours: &Colouring) -> Vec<Shape> {
    let (time_prefix, time_factor) = prefix(frame.time.abs(), "s");
    let time = format!("t = {} {time_prefix}s", short(frame.time / time_factor));
    let mut label = options.field.label().to_owned();
    if let Some(first) = label.get(..1).map(str::to_uppercase) {
        label.replace_range(..1, &first);
    }
    let is_titled = options.title.is_some();
    let heading = options.title.clone().unwrap_or_else(|| format!("{label}, {time}"));
    let unit = colours.unit();
    let [low, high] = colours.extremes.map(|v| short(v / colours.factor));
    let mut facts = Vec::new();
    if is_titled {
        facts.push(format!("{}, {time}", options.field.label()));
    }
    facts.push(format!("{low} to {high} {unit}").trim().to_owned());
    if options.deformation != 1.0 {
        facts.push(format!("displacements × {}", short_factor(options.deformation)));
    }
    let left = axes.window[0][0];
    vec![
        text([left, 20.0 + 0.75 * LARGE], &heading, LARGE, Anchor::Start),
        Shape::Text {
            at: [left, 20.0 + LARGE + SMALL + 4.0],
            text: facts.join(" · "),
            size: SMALL,
            anchor: Anchor::Start,
            turned: false,
            colour: Colour::GREY,
        },
    ]
}

fn short_factor(factor: f64) -> String {
    factor.to_string().replace('-', "−")
}
