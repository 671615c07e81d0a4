//! Points as users give them: in the plane or in space.

use std::fmt;

use crate::error::PostError;

/// A point, m. Whether it is one of the plane or of space shows before results are opened; that
/// it fits them is seen when it is used.
///
/// ```
/// use ypsilon_post::Point;
/// assert_eq!(Point::parse("--point", "0.5, 2")?, Point::Plane([0.5, 2.0]));
/// assert_eq!(Point::parse("--point", "0.5,2,-1")?, Point::Space([0.5, 2.0, -1.0]));
/// # Ok::<(), ypsilon_post::PostError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Point {
    /// x and y.
    Plane([f64; 2]),
    /// x, y and z.
    Space([f64; 3]),
}

impl Point {
    /// Two or three numbers with commas between them.
    ///
    /// # Errors
    /// An error that names `what` they are for, if they are something else.
    pub fn parse(what: &'static str, words: &str) -> Result<Self, PostError> {
        let numbers: Option<Vec<f64>> = words.split(',').map(|word| finite(word.trim())).collect();
        numbers.and_then(|numbers| Self::of(&numbers)).ok_or_else(|| {
            PostError::words(what, words, "expected X,Y in the plane or X,Y,Z in space")
        })
    }

    /// A point with these coordinates; none if they are not two or three.
    #[must_use]
    pub fn of(coordinates: &[f64]) -> Option<Self> {
        match *coordinates {
            [x, y] => Some(Self::Plane([x, y])),
            [x, y, z] => Some(Self::Space([x, y, z])),
            _ => None,
        }
    }

    /// Its two or three coordinates.
    #[must_use]
    pub fn coordinates(&self) -> &[f64] {
        match self {
            Self::Plane(x) => x,
            Self::Space(x) => x,
        }
    }

    /// Its coordinates in results of `D` dimensions.
    ///
    /// # Errors
    /// If it has others.
    pub fn within<const D: usize>(&self) -> Result<[f64; D], PostError> {
        self.coordinates().try_into().map_err(|_| self.unfit(D))
    }

    /// Checks that it is one of results of so many dimensions.
    ///
    /// # Errors
    /// If it is not.
    pub fn check(&self, dimension: usize) -> Result<(), PostError> {
        if self.coordinates().len() == dimension { Ok(()) } else { Err(self.unfit(dimension)) }
    }

    fn unfit(&self, dimension: usize) -> PostError {
        let form = if dimension > 2 { "X,Y,Z" } else { "X,Y" };
        PostError::Nothing(format!(
            "the point {self} has {} coordinates, but the results are of bodies {}; expected {form}",
            self.coordinates().len(),
            in_words(dimension)
        ))
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numbers: Vec<String> = self.coordinates().iter().map(f64::to_string).collect();
        f.write_str(&numbers.join(","))
    }
}

/// Where bodies of so many dimensions are, for messages.
pub(crate) fn in_words(dimension: usize) -> &'static str {
    if dimension > 2 { "in space" } else { "in the plane" }
}

/// A finite number.
pub(crate) fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|x: &f64| x.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_do_not_fit_the_results_are_told() {
        let plane = Point::Plane([0.5, -1.0]);
        assert_eq!(plane.within::<2>().ok(), Some([0.5, -1.0]));
        let fault = plane.within::<3>().expect_err("a fault").to_string();
        assert_eq!(
            fault,
            "the point 0.5,-1 has 2 coordinates, but the results are of bodies in space; \
             expected X,Y,Z"
        );
        let fault = Point::Space([0.0; 3]).within::<2>().expect_err("a fault").to_string();
        assert!(fault.ends_with("bodies in the plane; expected X,Y"), "{fault}");
        for words in ["1", "1,2,3,4", "1,x", "1,inf", ""] {
            assert!(Point::parse("--point", words).is_err(), "{words}");
        }
    }
}
