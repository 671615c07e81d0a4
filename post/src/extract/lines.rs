//! Values along a straight line or an arc.

use super::{
    locate::{Location, Locator},
    only_in_the_plane,
};
use crate::Point;
use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::{Frame, FrameChoice, Results, by_dimension};
use crate::table::Table;
use crate::vectors::{length, minus};
use ypsilon_converters::stress_measures::SymmetricTensor;

/// A path through the undeformed bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Path {
    /// From a point to another, m.
    Line([Point; 2]),
    /// About a centre at a radius, m, from an angle to another, degrees: 0 points right, 90 up.
    /// The arch coordinate s counts from the first angle. In the plane only.
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
    fn at<const D: usize>(&self, share: f64) -> Result<([f64; D], f64), PostError> {
        match *self {
            Self::Line([a, b]) => {
                let (a, b) = (a.within::<D>()?, b.within::<D>()?);
                let way = minus(b, a);
                let place = std::array::from_fn(|axis| a[axis] + share * way[axis]);
                Ok((place, share * length(way)))
            }
            Self::Arc { centre, radius, angles } => {
                let turned = share * (angles[1] - angles[0]);
                let (sine, cosine) = (angles[0] + turned).to_radians().sin_cos();
                let place = [centre[0] + radius * cosine, centre[1] + radius * sine];
                Ok((Point::Plane(place).within()?, radius * turned.abs().to_radians()))
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
/// results, the path has other dimensions than the bodies, or a file cannot be read.
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
    if matches!(path, Path::Arc { .. }) {
        only_in_the_plane(results, "an arch", "`line` from X,Y,Z to X,Y,Z")?;
    }
    by_dimension!(results, along_in(path, samples, fields, times))
}

fn along_in<const D: usize, const C: usize>(
    results: &mut Results,
    path: &Path,
    samples: usize,
    fields: &[Field],
    times: &[FrameChoice],
) -> Result<Table, PostError> {
    let mut headings = ["time (s)", "s (m)"].map(str::to_owned).to_vec();
    let is_arc = matches!(path, Path::Arc { .. });
    if is_arc {
        headings.push("angle (deg)".to_owned());
    }
    headings.extend(["x (m)", "y (m)", "z (m)"].into_iter().take(D).map(str::to_owned));
    headings.extend(fields.iter().map(|f| f.heading()));
    if is_arc {
        let local = ["stress along arc (Pa)", "stress across arc (Pa)", "shear in arc axes (Pa)"];
        headings.extend(local.map(str::to_owned));
    }
    let mut table = Table::new(headings);
    for &time in times {
        let frame = results.frame_in::<D, C>(results.index_of(time)?)?;
        let initial = frame.initial();
        let locator = Locator::new(&frame.elements, &initial);
        let values: Vec<_> = fields.iter().map(|f| f.values(&frame)).collect::<Result<_, _>>()?;
        let mut any = false;
        for sample in 0..samples {
            let share = sample as f64 / (samples - 1) as f64;
            let (place, length) = path.at::<D>(share)?;
            let mut row = vec![frame.time, length];
            if let Path::Arc { angles, .. } = path {
                row.push(angles[0] + share * (angles[1] - angles[0]));
            }
            row.extend(place);
            let found = locator.find(place);
            any |= found.is_some();
            for values in &values {
                row.push(found.map_or(f64::NAN, |at| sampled(&frame, values, at)));
            }
            if let Path::Arc { centre, .. } = path {
                let stress = frame.stress.as_ref().zip(found);
                let stress = stress.and_then(|(all, at)| all.get(at.element));
                row.extend(in_arc_axes(stress, *centre, [place[0], place[1]]));
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

/// The value at a place of an element: exact where all its nodes have the same.
fn sampled<const D: usize, const C: usize>(
    frame: &Frame<D, C>,
    values: &FieldValues,
    Location { element, weights }: Location<C>,
) -> f64 {
    if let FieldValues::Nodes(all) = values {
        let mut nodes = frame.shape(element, weights).map(|(node, _)| all.get(node as usize));
        if let Some(first) = nodes.next().flatten()
            && nodes.all(|value| value == Some(first))
        {
            return *first;
        }
    }
    values.within(frame, element, weights)
}

/// Normal stress along the arc, across it, and the shear stress between them.
fn in_arc_axes(stress: Option<&SymmetricTensor>, centre: [f64; 2], place: [f64; 2]) -> [f64; 3] {
    let Some(&[xx, yy, _, xy, ..]) = stress else { return [f64::NAN; 3] };
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
        let stress = [2.0, -1.0, 0.0, 0.5, 0.0, 0.0];
        assert_eq!(in_arc_axes(Some(&stress), [0.0, 0.0], [3.0, 0.0]), [-1.0, 2.0, 0.5]);
        assert_eq!(in_arc_axes(Some(&stress), [1.0, 0.0], [1.0, 2.0]), [2.0, -1.0, -0.5]);
        let [along, across, shear] = in_arc_axes(Some(&stress), [0.0; 2], [1.0, 1.0]);
        assert!((across - 1.0).abs() < 1e-15 && along.abs() < 1e-15 && (shear + 1.5).abs() < 1e-15);
    }

    #[test]
    fn the_arch_coordinate_counts_from_the_first_angle() {
        let arc = Path::Arc { centre: [0.0, 1.0], radius: 2.0, angles: [180.0, 0.0] };
        let (place, s) = arc.at::<2>(0.5).expect("a place");
        assert!((place[0]).abs() < 1e-15 && (place[1] - 3.0).abs() < 1e-15);
        assert!((s - std::f64::consts::PI).abs() < 1e-15);
    }
}
