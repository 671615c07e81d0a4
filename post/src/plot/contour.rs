//! Contour pictures.

use std::collections::BTreeMap;

use super::axes::{Axes, BOTTOM_MARGIN, MEDIUM, SMALL, left_margin, text, title, widest};
use super::bands::band;
use super::colours::{Colour, ColourMap};
use super::font::width;
use super::outline::outline;
use super::picture::{Anchor, Picture, Shape};
use super::scale::{Ticks, prefix, short};
use super::weld::{averaged, weld};
use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::{Frame, Joint, JointState};

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

/// Shades of a field that is not drawn as bands: an odd number, so that a field that is the same
/// everywhere up to rounding lies in the middle of one.
const SHADES: usize = 255;
/// Strips of the colour bar then.
const STRIPS: usize = 85;
/// Bands at most.
const MOST_BANDS: usize = 256;
/// Width of the colour bar, pixels.
const BAR: f64 = 18.0;
/// Room between axes and colour bar, pixels.
const BAR_GAP: f64 = 24.0;
/// Height of the title, pixels.
const LARGE: f64 = 18.0;
/// Least height of the axes, pixels: the colour bar needs it.
const LEAST_HEIGHT: f64 = 200.0;
/// Height of the axes at most, relative to the width of the picture.
const LARGEST_HEIGHT: f64 = 1.1;
/// Smallest and largest width of pictures, pixels.
const WIDTHS: std::ops::RangeInclusive<u32> = 300..=8000;

const TENSION: Colour = Colour([0xe0, 0x00, 0x8c]);
const MIXED: Colour = Colour([0xff, 0x8c, 0x00]);
const SHEAR: Colour = Colour([0x00, 0x00, 0x00]);
const UNKNOWN: Colour = Colour([0x8b, 0x45, 0x13]);
const SOFTENING: Colour = Colour([0x77, 0x77, 0x77]);

/// Draws a field of a frame on its deformed bodies.
///
/// # Errors
/// If the field is not in the frame, there is no triangle, or the options make no sense.
pub fn contour(frame: &Frame, options: &ContourOptions) -> Result<Picture, PostError> {
    check(options)?;
    if frame.triangles.is_empty() {
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
        (FieldValues::Triangles(each), true) => Some(averaged(frame, each, &classes, count)),
        (FieldValues::Triangles(_), false) => None,
        (FieldValues::Nodes(_), _) => Some(values.corners(frame)),
    };
    inside.extend(match &corners {
        Some(corners) => banded(frame, &points, corners, axes, &colours),
        None => flat(frame, &points, &values.of_triangles(frame), axes, &colours),
    });
    let to_pixels = |lines: Vec<Vec<[f64; 2]>>| -> Vec<Vec<[f64; 2]>> {
        lines.into_iter().map(|l| l.into_iter().map(|p| axes.pixel(p)).collect()).collect()
    };
    let line = |lines, colour, width, dash| Shape::Lines { lines, colour, width, dash };
    if options.edges {
        let rings = frame.triangles.iter().map(|&t| {
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

/// Numbers to colours, and what the bar says.
struct Colouring {
    map: ColourMap,
    bands: usize,
    low: f64,
    high: f64,
    /// Smallest and largest value of the field.
    extremes: [f64; 2],
    prefix: String,
    unit: &'static str,
    factor: f64,
}

impl Colouring {
    fn new(options: &ContourOptions, values: &FieldValues) -> Result<Self, PostError> {
        let mut sorted: Vec<f64> = values.all().iter().copied().filter(|v| v.is_finite()).collect();
        sorted.sort_by(f64::total_cmp);
        let (Some(&least), Some(&most)) = (sorted.first(), sorted.last()) else {
            let name = options.field.name();
            return Err(PostError::Nothing(format!("the field {name} has no finite value")));
        };
        let [low, high] = match options.range {
            Range::Full => [least, most],
            Range::Fixed([low, high]) => {
                if !(low < high && low.is_finite() && high.is_finite()) {
                    let found = format!("{low}:{high}");
                    let expected = "expected LOW:HIGH, the smaller number first";
                    return Err(PostError::words("the range", found, expected));
                }
                [low, high]
            }
            Range::Robust(percent) => {
                if !(0.0..50.0).contains(&percent) {
                    let expected = "expected 0 to less than 50";
                    let found = percent.to_string();
                    return Err(PostError::words("the percentage left out", found, expected));
                }
                let at = |share: f64| {
                    let index = (share * (sorted.len() - 1) as f64).round() as usize;
                    sorted.get(index).copied().unwrap_or(most)
                };
                [at(percent / 100.0), at(1.0 - percent / 100.0)]
            }
        };
        let [low, high] = opened(low, high);
        let is_signed = options.field.is_signed() && low < 0.0 && high > 0.0;
        let natural = if is_signed { ColourMap::CoolWarm } else { ColourMap::Viridis };
        let unit = options.field.quantity().unit();
        let (prefix, factor) = prefix(low.abs().max(high.abs()), unit);
        let map = options.map.unwrap_or(natural);
        let extremes = [least, most];
        Ok(Self { map, bands: options.bands, low, high, extremes, prefix, unit, factor })
    }

    /// Colour of a value.
    fn colour(&self, value: f64) -> Colour {
        let share = match self.map {
            ColourMap::CoolWarm => 0.5 + 0.5 * value / self.low.abs().max(self.high.abs()),
            ColourMap::Viridis => (value - self.low) / (self.high - self.low),
        };
        self.map.colour(share)
    }

    /// Number of the shade of a value, and the value in the middle of a shade.
    fn shade(&self, value: f64) -> usize {
        let share = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        ((share * SHADES as f64) as usize).min(SHADES - 1)
    }

    fn middle(&self, index: usize, of: usize) -> f64 {
        self.low + (index as f64 + 0.5) / of as f64 * (self.high - self.low)
    }

    /// Unit with its prefix.
    fn unit(&self) -> String {
        format!("{}{}", self.prefix, self.unit).trim().to_owned()
    }
}

/// A range with a width: a field that is the same everywhere up to rounding gets one.
fn opened(low: f64, high: f64) -> [f64; 2] {
    let size = low.abs().max(high.abs());
    if high - low > 1e-9 * size {
        [low, high]
    } else if size > 0.0 {
        let middle = 0.5 * (low + high);
        [middle - 0.05 * size, middle + 0.05 * size]
    } else {
        [0.0, 1.0]
    }
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
                    let corners = frame.triangles.iter();
                    corners.flat_map(|&t| Frame::corners(t, points)).collect()
                };
                let mut shown = used(points);
                if options.undeformed {
                    shown.extend(used(initial));
                }
                let [low, high] = Frame::bounds(&shown)?;
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

/// Triangles of one colour each, one shape for each colour.
fn flat(
    frame: &Frame,
    points: &[[f64; 2]],
    values: &[f64],
    axes: &Axes,
    colours: &Colouring,
) -> Vec<Shape> {
    let mut of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    for (&triangle, &value) in frame.triangles.iter().zip(values) {
        let ring = Frame::corners(triangle, points).map(|p| axes.pixel(p)).to_vec();
        let colour = if value.is_finite() {
            colours.colour(colours.middle(colours.shade(value), SHADES))
        } else {
            colours.map.colour(f64::NAN)
        };
        of_colour.entry(colour).or_default().push(ring);
    }
    polygons(of_colour)
}

/// Triangles cut into bands, one shape for each colour.
fn banded(
    frame: &Frame,
    points: &[[f64; 2]],
    values: &[[f64; 3]],
    axes: &Axes,
    colours: &Colouring,
) -> Vec<Shape> {
    let mut of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    let step = (colours.high - colours.low) / colours.bands as f64;
    let of_band = |value: f64| {
        (((value - colours.low) / step).floor().clamp(0.0, (colours.bands - 1) as f64)) as usize
    };
    for (&triangle, &values) in frame.triangles.iter().zip(values) {
        let corners = Frame::corners(triangle, points).map(|p| axes.pixel(p));
        if !values.iter().all(|v| v.is_finite()) {
            of_colour.entry(colours.map.colour(f64::NAN)).or_default().push(corners.to_vec());
            continue;
        }
        let [a, b, c] = values;
        let (first, last) = (of_band(a.min(b).min(c)), of_band(a.max(b).max(c)));
        for index in first..=last {
            // the first and the last band take what lies outside of the range
            let edge = |index: usize| colours.low + index as f64 * step;
            let low = if index == 0 { -f64::MAX } else { edge(index) };
            let high = if index + 1 == colours.bands { f64::MAX } else { edge(index + 1) };
            let ring =
                if first == last { corners.to_vec() } else { band(corners, values, low, high) };
            if ring.len() > 2 {
                let colour = colours.colour(colours.middle(index, colours.bands));
                of_colour.entry(colour).or_default().push(ring);
            }
        }
    }
    polygons(of_colour)
}

fn polygons(of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>>) -> Vec<Shape> {
    let shape = |(colour, rings)| Shape::Polygons { rings, colour, seam: 1.4 };
    of_colour.into_iter().map(shape).collect()
}

fn bar_ticks(colours: &Colouring) -> Ticks {
    Ticks::new(colours.low / colours.factor, colours.high / colours.factor, 6)
}

fn colour_bar(axes: &Axes, colours: &Colouring, stepped: bool) -> Vec<Shape> {
    let left = axes.window[1][0] + BAR_GAP;
    let right = left + BAR;
    // room for the unit above and for pointed ends
    let top = axes.window[0][1] + 26.0;
    let bottom = axes.window[1][1] - 14.0;
    let y =
        |value: f64| bottom - (value - colours.low) / (colours.high - colours.low) * (bottom - top);
    let strips = if stepped { colours.bands } else { STRIPS };
    let mut shapes = Vec::new();
    for strip in 0..strips {
        let edge = |i: usize| bottom - i as f64 / strips as f64 * (bottom - top);
        let (low, high) = (edge(strip), edge(strip + 1));
        let ring = vec![[left, low], [right, low], [right, high], [left, high]];
        let colour = colours.colour(colours.middle(strip, strips));
        let seam = if stepped { 0.0 } else { 1.0 };
        shapes.push(Shape::Polygons { rings: vec![ring], colour, seam });
    }
    let mut border = vec![vec![[left, bottom], [left, top]], vec![[right, bottom], [right, top]]];
    let middle = 0.5 * (left + right);
    let mut end = |beyond: bool, y: f64, tip: f64, value: f64| {
        if beyond {
            let ring = vec![[left, y], [middle, tip], [right, y]];
            let colour = colours.colour(value);
            shapes.push(Shape::Polygons { rings: vec![ring.clone()], colour, seam: 0.0 });
            border.push(ring);
        } else {
            border.push(vec![[left, y], [right, y]]);
        }
    };
    let tolerance = 1e-9 * (colours.high - colours.low);
    end(colours.extremes[0] < colours.low - tolerance, bottom, bottom + 12.0, colours.low);
    end(colours.extremes[1] > colours.high + tolerance, top, top - 12.0, colours.high);
    let ticks = bar_ticks(colours);
    for (value, label) in ticks.values.iter().zip(&ticks.labels) {
        let y = y(value * colours.factor);
        border.push(vec![[right, y], [right + 4.0, y]]);
        shapes.push(text([right + 8.0, y + 0.36 * SMALL], label, SMALL, Anchor::Start));
    }
    shapes.push(Shape::Lines { lines: border, colour: Colour::INK, width: 0.9, dash: None });
    let unit = colours.unit();
    if !unit.is_empty() {
        shapes.push(text([left, axes.window[0][1] + 6.0], &unit, MEDIUM, Anchor::Start));
    }
    shapes
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

/// What the legend of joints says: colour, width, words.
type Legend = Vec<(Colour, f64, String)>;

fn joint_lines(
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
fn legend_shapes(legend: &Legend, axes: &Axes, mut y: f64, room: f64) -> (Vec<Shape>, f64) {
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
