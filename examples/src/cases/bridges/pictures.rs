//! Pictures of bridges.

use super::family::BridgeRun;
use crate::{Bench, CaseError, case::Figure};
use ypsilon_post::{
    field::Field,
    plot::{ContourOptions, Curve, CurveOptions, Range, contour, curves},
    results::Frame,
};

/// A contour picture of a state.
pub(super) struct Shown {
    pub field: Field,
    pub range: Range,
    pub deformation: f64,
    pub title: String,
}

impl Shown {
    pub fn new(field: Field, title: impl Into<String>) -> Self {
        Shown { field, range: Range::Full, deformation: 1.0, title: title.into() }
    }
}

/// Draws a state.
pub(super) fn state(
    bench: &Bench,
    frame: &Frame,
    shown: Shown,
    file: &str,
    caption: &str,
) -> Result<Figure, CaseError> {
    let options = ContourOptions {
        range: shown.range,
        deformation: shown.deformation,
        title: Some(shown.title),
        width: 640,
        bands: 12,
        ..ContourOptions::new(shown.field)
    };
    bench.picture(&contour(frame, &options)?, file, caption)
}

/// Draws curves of the three bridges.
pub(super) fn lines(
    bench: &Bench,
    lines: Vec<(String, Vec<[f64; 2]>)>,
    labels: [&str; 2],
    file: &str,
    caption: &str,
) -> Result<Figure, CaseError> {
    let all: Vec<Curve> = lines.into_iter().map(|(name, points)| Curve { name, points }).collect();
    let options = CurveOptions {
        title: String::new(),
        labels: labels.map(str::to_owned),
        ranges: [None, None],
        markers: false,
        size: [900, 480],
    };
    bench.picture(&curves(&all, &options)?, file, caption)
}

/// σyy or another stress of each bridge at a time, one picture each.
pub(super) fn stresses(
    bench: &Bench,
    runs: &mut [BridgeRun],
    field: Field,
    time: f64,
    what: &str,
) -> Result<Vec<Figure>, CaseError> {
    let mut figures = Vec::new();
    for run in runs {
        let frame = run.frame_at(time)?;
        let shown = Shown::new(field, format!("{}: {}", run.label, what));
        let file = format!("{}-{}.png", field.name(), slug(run.label));
        let caption = format!("{} for {}", what, run.label);
        figures.push(state(bench, &frame, shown, &file, &caption)?);
    }
    Ok(figures)
}

/// `D = 0.25 L` as a part of a file name.
pub(super) fn slug(label: &str) -> String {
    label.chars().filter(|c| c.is_ascii_digit()).collect()
}
