//! By what reals are divided before they are coded.

use crate::database::Database;
use crate::dialect::Dialect;

/// The output scales of a deck: values of this size fill the range of a number.
///
/// The default is that of decks that give none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// `DCSIZC`, m.
    pub coordinate: f64,
    /// `DCSIZF`, N.
    pub force: f64,
    /// `DCSIZS`, Pa.
    pub stress: f64,
    /// `DCSIZV`, m/s.
    pub velocity: f64,
    /// `DCSIZD`, m: shear displacement and dilation of joints.
    pub displacement: f64,
    /// `DCSIZA`, m: apertures are coded as `log10(aperture) / log10(DCSIZA)`.
    pub aperture: f64,
}

impl Default for Scales {
    /// What a classic deck without any of the keywords has here. The original has no values of
    /// its own for stress, displacement and aperture.
    fn default() -> Self {
        Self::from_database(&Database::new(Dialect::Classic)).unwrap_or(Self {
            coordinate: 1.0,
            force: 1.0,
            stress: 1.0,
            velocity: 1.0,
            displacement: 1.0,
            aperture: 1e-7,
        })
    }
}

impl Scales {
    /// The scales that a deck has set so far; `None` if its dialect is not the classic one.
    #[must_use]
    pub fn from_database(database: &Database) -> Option<Self> {
        (database.dialect() == Dialect::Classic).then(|| Self {
            coordinate: database.real("YDC/DCSIZC"),
            force: database.real("YDC/DCSIZF"),
            stress: database.real("YDC/DCSIZS"),
            velocity: database.real("YDC/DCSIZV"),
            displacement: database.real("YDC/DCSIZD"),
            aperture: database.real("YDC/DCSIZA"),
        })
    }

    /// An aperture in units of its scale; infinite for a closed joint.
    pub(super) fn aperture_to_unit(&self, aperture: f64) -> f64 {
        aperture.log10() / self.aperture.log10()
    }

    pub(super) fn aperture_from_unit(&self, unit: f64) -> f64 {
        10.0_f64.powf(unit * self.aperture.log10())
    }
}
