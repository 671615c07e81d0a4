//! `contactforce.txt`.

use std::fmt;

use super::text::E10;

/// One line of `contactforce.txt`, written with each snapshot; `Display` gives it without line end.
///
/// The original begins the file anew with snapshot 0 and appends otherwise. It forgets to set the
/// last two sums to 0 before it adds, so its files hold whatever was on its stack there.
///
/// ```
/// use yformat::classic_output::ContactForceSums;
///
/// let sums = ContactForceSums { magnitudes: [0.25, 1.5e6], of_property_5: [0.0, -2.0] };
/// assert_eq!(sums.to_string(), "+2.500e-01 +1.500e+06 +0.000e+00 -2.000e+00");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactForceSums {
    /// Sums of the magnitudes of the nodal contact forces in x and in y over all nodes, N.
    pub magnitudes: [f64; 2],
    /// Sums of the contact forces over the nodes with property set 5, N.
    pub of_property_5: [f64; 2],
}

impl fmt::Display for ContactForceSums {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ([a, b], [c, d]) = (self.magnitudes, self.of_property_5);
        write!(f, "{} {} {} {}", E10.format(a), E10.format(b), E10.format(c), E10.format(d))
    }
}
