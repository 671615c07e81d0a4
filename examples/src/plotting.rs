//! Charts of cases.

use crate::CaseError;
use ypsilon_post::plot::{Curve, CurveOptions, Picture, curves};

/// A chart of curves, small enough for a README.
///
/// # Errors
/// If no curve has a finite point.
pub fn chart(title: &str, labels: [&str; 2], lines: &[Curve]) -> Result<Picture, CaseError> {
    let options = CurveOptions {
        title: title.to_owned(),
        labels: labels.map(str::to_owned),
        ranges: [None, None],
        markers: false,
        size: [720, 440],
    };
    Ok(curves(lines, &options)?)
}

/// A curve.
#[must_use]
pub fn line(name: &str, points: Vec<[f64; 2]>) -> Curve {
    Curve { name: name.to_owned(), points }
}

/// A curve through a function.
#[must_use]
pub fn function(name: &str, [from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> Curve {
    let at = |k: i32| from + (to - from) * f64::from(k) / 100.0;
    line(name, (0..=100).map(|k| [at(k), f(at(k))]).collect())
}

/// Points as crosses: `spans` are what is shown of either axis.
#[must_use]
pub fn marks(name: &str, points: &[[f64; 2]], spans: [f64; 2]) -> Curve {
    let [dx, dy] = [0.010 * spans[0], 0.016 * spans[1]];
    let gap = [f64::NAN; 2];
    let cross = |&[x, y]: &[f64; 2]| {
        [[x - dx, y - dy], [x + dx, y + dy], gap, [x - dx, y + dy], [x + dx, y - dy], gap]
    };
    line(name, points.iter().flat_map(cross).collect())
}
