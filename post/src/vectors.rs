//! Places and directions in the plane and in space.

use crate::error::PostError;

/// `a - b`.
pub(crate) fn minus<const D: usize>(a: [f64; D], b: [f64; D]) -> [f64; D] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// The middle between two places.
pub(crate) fn middle<const D: usize>(a: [f64; D], b: [f64; D]) -> [f64; D] {
    let half = minus(b, a).map(|d| 0.5 * d);
    std::array::from_fn(|axis| a[axis] + half[axis])
}

/// Length of a vector.
pub(crate) fn length<const D: usize>(v: [f64; D]) -> f64 {
    v.into_iter().reduce(f64::hypot).unwrap_or(0.0)
}

/// Area of the parallelogram that two vectors span.
pub(crate) fn area_between<const D: usize>(a: [f64; D], b: [f64; D]) -> f64 {
    let pairs = (0..D).flat_map(|i| (i + 1..D).map(move |j| (i, j)));
    pairs.map(|(i, j)| a[i] * b[j] - a[j] * b[i]).fold(0.0, f64::hypot)
}

/// Twice the area of a triangle in the plane, six times the volume of a tetrahedron in space:
/// above 0 for triangles that run counter-clockwise, and for tetrahedra whose last corner lies
/// on the side to which the others do. NaN in other dimensions.
pub(crate) fn content<const D: usize, const C: usize>(corners: &[[f64; D]; C]) -> f64 {
    let Some((&first, others)) = corners.split_first() else { return f64::NAN };
    let edges: [[f64; D]; D] = std::array::from_fn(|edge| {
        others.get(edge).map_or([f64::NAN; D], |&corner| minus(corner, first))
    });
    match *edges.as_flattened() {
        [ax, ay, bx, by] => ax * by - bx * ay,
        [ax, ay, az, bx, by, bz, cx, cy, cz] => {
            ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
        }
        _ => f64::NAN,
    }
}

/// Smallest and largest coordinates, m.
///
/// # Errors
/// If no node has finite coordinates.
pub fn bounds<const D: usize>(points: &[[f64; D]]) -> Result<[[f64; D]; 2], PostError> {
    let mut bounds = [[f64::INFINITY; D], [f64::NEG_INFINITY; D]];
    for point in points.iter().filter(|p| p.iter().all(|x| x.is_finite())) {
        for axis in 0..D {
            bounds[0][axis] = bounds[0][axis].min(point[axis]);
            bounds[1][axis] = bounds[1][axis].max(point[axis]);
        }
    }
    if bounds[0].iter().zip(&bounds[1]).all(|(low, high)| low <= high) {
        Ok(bounds)
    } else {
        Err(PostError::Nothing("no node has finite coordinates".to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_areas_and_volumes() {
        assert_eq!(length([3.0, -4.0]), 5.0);
        assert!((length([2.0, 3.0, -6.0]) - 7.0).abs() < 1e-15);
        assert_eq!(area_between([2.0, 0.0], [1.0, -3.0]), 6.0);
        assert_eq!(area_between([0.0, 2.0, 0.0], [0.0, 1.0, 3.0]), 6.0);
        assert_eq!(content(&[[0.0, 0.0], [2.0, 0.0], [0.0, 3.0]]), 6.0);
        assert_eq!(content(&[[1.0; 3], [3.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 5.0]]), 24.0);
        assert_eq!(middle([1.0, 2.0, 3.0], [3.0, 2.0, -3.0]), [2.0, 2.0, 0.0]);
    }

    #[test]
    fn places_that_are_no_numbers_have_no_bounds() {
        let points = [[1.0, 2.0, 3.0], [f64::NAN, 0.0, 9.0], [-1.0, 5.0, 3.0]];
        assert_eq!(bounds(&points).ok(), Some([[-1.0, 2.0, 3.0], [1.0, 5.0, 3.0]]));
        assert!(bounds::<2>(&[]).is_err());
    }
}
