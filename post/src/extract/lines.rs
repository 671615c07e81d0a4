//! Values along a straight line or an arc.

use super::locate::Locator;
use crate::error::PostError;
use crate::field::Field;
use crate::results::{FrameChoice, Results};
use crate::table::Table;

/// A path through the undeformed bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// From a point to another, m.
    Line([[f64; 2]; 2]),
    /// About a centre at a radius, m, from an angle to another, degrees: 0 points right, 90 up.
    /// The arch coordinate s counts from the first angle.
    Arc {
        /// Centre, m.
        centre: [f64; 2],
        /// Radius, m.
        radius: f64,
        /// Angles, degrees.
        angles: [f64; 2],
    },
}

impl Path {
    /// Place and arc length at a share of the path.
    fn at(&self, share: f64) -> ([f64; 2], f64) {
        match *self {
            Self::Line([a, b]) => {
                let length = (b[0] - a[0]).hypot(b[1] - a[1]);
                ([0, 1].map(|k| a[k] + share * (b[k] - a[k])), share * length)
            }
            Self::Arc { centre, radius, angles } => {
                let turned = share * (angles[1] - angles[0]);
                let (sine, cosine) = (angles[0] + turned).to_radians().sin_cos();
                let place = [centre[0] + radius * cosine, centre[1] + radius * sine];
                (place, radius * turned.abs().to_radians())
            }
        }
    }
}

/// Values of `fields` at `samples` places along a path, at one or more times. The path lies in
/// the undeformed bodies; each row names the place there. Places outside of all bodies have NaN.
///
/// On an arc three columns more give the normal stress along the arc and across it and the
/// shear stress between them, Pa.
///
/// # Errors
/// If no sample lies in a body, fewer than 2 samples are asked for, a field is not in the
/// results, or a file cannot be read.
pub fn along(
    results: &mut Results,
    path: &Path,
    samples: usize,
    fields: &[Field],
    times: &[FrameChoice],
) -> Result<Table, PostError> {
    if !(2..=1_000_000).contains(&samples) {
        let expected = "expected 2 to 1000000";
        return Err(PostError::words("the number of samples", samples.to_string(), expected));
    }
    let mut headings = ["time (s)", "s (m)", "x (m)", "y (m)"].map(str::to_owned).to_vec();
    let is_arc = matches!(path, Path::Arc { .. });
    if is_arc {
        headings.insert(2, "angle (deg)".to_owned());
    }
    headings.extend(fields.iter().map(|f| f.heading()));
    if is_arc {
        let local = ["stress along arc (Pa)", "stress across arc (Pa)", "shear in arc axes (Pa)"];
        headings.extend(local.map(str::to_owned));
    }
    let mut table = Table::new(headings);
    for &time in times {
        let frame = results.frame(results.index_of(time)?)?;
        let initial = frame.initial();
        let locator = Locator::new(&frame.triangles, &initial);
        let values: Vec<_> = fields.iter().map(|f| f.values(&frame)).collect::<Result<_, _>>()?;
        let corners: Vec<_> = values.iter().map(|v| v.corners(&frame)).collect();
        let mut any = false;
        for sample in 0..samples {
            let share = sample as f64 / (samples - 1) as f64;
            let (place, length) = path.at(share);
            let mut row = vec![frame.time, length, place[0], place[1]];
            if let Path::Arc { angles, .. } = path {
                row.insert(2, angles[0] + share * (angles[1] - angles[0]));
            }
            let found = locator.find(place);
            any |= found.is_some();
            for corners in &corners {
                row.push(found.map_or(f64::NAN, |at| {
                    let corners = corners.get(at.triangle).copied().unwrap_or([f64::NAN; 3]);
                    if corners[0] == corners[1] && corners[1] == corners[2] {
                        corners[0] // of the triangle: exact
                    } else {
                        corners.iter().zip(at.weights).map(|(v, w)| v * w).sum()
                    }
                }));
            }
            if let Path::Arc { centre, .. } = path {
                let stress = frame.stress.as_ref().zip(found);
                let stress = stress.and_then(|(all, at)| all.get(at.triangle));
                row.extend(in_arc_axes(stress, *centre, place));
            }
            table.rows.push(row);
        }
        if !any {
            return Err(PostError::Nothing(
                "the path lies in no body; it is meant in the undeformed bodies".to_owned(),
            ));
        }
    }
    Ok(table)
}

/// Normal stress along the arc, across it, and the shear stress between them.
fn in_arc_axes(stress: Option<&[f64; 4]>, centre: [f64; 2], place: [f64; 2]) -> [f64; 3] {
    let Some(&[xx, yy, _, xy]) = stress else { return [f64::NAN; 3] };
    let radius = (place[0] - centre[0]).hypot(place[1] - centre[1]);
    let n = [0, 1].map(|k| (place[k] - centre[k]) / radius);
    let across = xx * n[0] * n[0] + yy * n[1] * n[1] + 2.0 * xy * n[0] * n[1];
    let shear = (yy - xx) * n[0] * n[1] + xy * (n[0] * n[0] - n[1] * n[1]);
    [xx + yy - across, across, shear]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arc_axes_turn_the_stress() {
        let stress = [2.0, -1.0, 0.0, 0.5];
        assert_eq!(in_arc_axes(Some(&stress), [0.0, 0.0], [3.0, 0.0]), [-1.0, 2.0, 0.5]);
        assert_eq!(in_arc_axes(Some(&stress), [1.0, 0.0], [1.0, 2.0]), [2.0, -1.0, -0.5]);
        let [along, across, shear] = in_arc_axes(Some(&stress), [0.0; 2], [1.0, 1.0]);
        assert!((across - 1.0).abs() < 1e-15 && along.abs() < 1e-15 && (shear + 1.5).abs() < 1e-15);
    }

    #[test]
    fn the_arch_coordinate_counts_from_the_first_angle() {
        let arc = Path::Arc { centre: [0.0, 1.0], radius: 2.0, angles: [180.0, 0.0] };
        let (place, s) = arc.at(0.5);
        assert!((place[0]).abs() < 1e-15 && (place[1] - 3.0).abs() < 1e-15);
        assert!((s - std::f64::consts::PI).abs() < 1e-15);
    }
}
