//! From the numbers of a field to colours, and the bar that tells them.

use super::axes::{Axes, MEDIUM, SMALL, text};
use super::colours::{Colour, ColourMap};
use super::contour::{ContourOptions, Range};
use super::picture::{Anchor, Shape};
use super::scale::{Ticks, prefix};
use crate::error::PostError;
use crate::field::FieldValues;

/// Shades of a field that is not drawn as bands: an odd number, so that a field that is the same
/// everywhere up to rounding lies in the middle of one.
pub(super) const SHADES: usize = 255;
/// Strips of the colour bar then.
const STRIPS: usize = 85;
/// Width of the colour bar, pixels.
pub(super) const BAR: f64 = 18.0;
/// Room between axes and colour bar, pixels.
pub(super) const BAR_GAP: f64 = 24.0;

/// Numbers to colours, and what the bar says.
pub(super) struct Colouring {
    pub map: ColourMap,
    pub bands: usize,
    pub low: f64,
    pub high: f64,
    /// Smallest and largest value of the field.
    pub extremes: [f64; 2],
    pub prefix: String,
    pub unit: &'static str,
    pub factor: f64,
}

impl Colouring {
    pub fn new(options: &ContourOptions, values: &FieldValues) -> Result<Self, PostError> {
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
    pub fn colour(&self, value: f64) -> Colour {
        let share = match self.map {
            ColourMap::CoolWarm => 0.5 + 0.5 * value / self.low.abs().max(self.high.abs()),
            ColourMap::Viridis => (value - self.low) / (self.high - self.low),
        };
        self.map.colour(share)
    }

    /// Number of the shade of a value, and the value in the middle of a shade.
    pub fn shade(&self, value: f64) -> usize {
        let share = ((value - self.low) / (self.high - self.low)).clamp(0.0, 1.0);
        ((share * SHADES as f64) as usize).min(SHADES - 1)
    }

    pub fn middle(&self, index: usize, of: usize) -> f64 {
        self.low + (index as f64 + 0.5) / of as f64 * (self.high - self.low)
    }

    /// Unit with its prefix.
    pub fn unit(&self) -> String {
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

pub(super) fn bar_ticks(colours: &Colouring) -> Ticks {
    Ticks::new(colours.low / colours.factor, colours.high / colours.factor, 6)
}

pub(super) fn colour_bar(axes: &Axes, colours: &Colouring, stepped: bool) -> Vec<Shape> {
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
