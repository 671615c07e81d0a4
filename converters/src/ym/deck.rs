//! What the deck says about its snapshots.

use std::path::Path;

use yformat::database::Database;
use yformat::deck::{Deck, DeckReader};
use yformat::dialect::Dialect;
use yformat::ym::Scales;

use super::YmNotice;
use crate::error::{ConvertError, at};

/// Scales and times of a series.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SeriesDeck {
    /// By what values were divided.
    pub scales: Scales,
    /// When snapshots were written, if the deck says so.
    pub times: Option<SnapshotTimes>,
    /// What is missing or doubtful.
    pub notices: Vec<YmNotice>,
}

/// From snapshot numbers to times.
///
/// A snapshot is written after step `n` whenever `n` is a multiple of the interval, and shows the
/// coordinates and velocities at the end of that step. Snapshot `ICOUTI` of the deck belongs to the
/// first such step from `NCSTEP` on. The times of decks with several stages follow the last values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SnapshotTimes {
    /// `NCSTEP`.
    pub first_step: i64,
    /// `DCTIME`, s: time at the beginning of that step.
    pub first_time: f64,
    /// `DCSTEC`, s.
    pub time_step: f64,
    /// `ICOUTF`, at least 1.
    pub interval: i64,
    /// `ICOUTI`.
    pub first_number: i64,
}

impl SnapshotTimes {
    /// The time of a snapshot, s: the end of its step. Numbers below the first one, of an earlier
    /// run, get the times that they had if that run had the same intervals.
    #[must_use]
    pub fn time(&self, number: u64) -> f64 {
        let interval = self.interval.max(1);
        let before = self.first_step.rem_euclid(interval);
        let first_step = if before == 0 { 0 } else { interval - before };
        let snapshots = number as f64 - self.first_number as f64;
        let steps = first_step as f64 + snapshots * interval as f64 + 1.0;
        self.first_time + steps * self.time_step
    }
}

impl SeriesDeck {
    /// Reads the deck; the last value of each keyword counts, whatever it stands beside. A deck with
    /// an error counts up to that.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(path: &Path) -> Result<Self, ConvertError> {
        let outcome = DeckReader::new().dialect(Dialect::Classic).read(path).map_err(at(path))?;
        let mut about = Self::from_deck(&outcome.deck);
        if let Some(error) = outcome.diagnostics.iter().find(|found| found.is_error()) {
            about.notices.insert(0, YmNotice::DeckError { message: error.to_string() });
        }
        Ok(about)
    }

    /// What a deck that was read by the classic dialect says.
    #[must_use]
    pub fn from_deck(deck: &Deck) -> Self {
        let mut values = Database::new(Dialect::Classic);
        for (index, given) in deck.assignments() {
            if deck.dialect() == Dialect::Classic && given.keyword.database == "YDC" {
                values.apply(deck, index);
            }
        }
        let scales = Scales::from_database(&values).unwrap_or_default();
        let mut notices = Vec::new();
        for (name, keyword, taken) in [
            ("YDC/DCSIZS", "DCSIZS", format!("{} Pa", scales.stress)),
            ("YDC/DCSIZD", "DCSIZD", format!("{} m", scales.displacement)),
            ("YDC/DCSIZA", "DCSIZA", format!("{:e} m", scales.aperture)),
        ] {
            if values.given(name).is_none() {
                notices.push(YmNotice::NoScale { keyword, taken });
            }
        }
        for (keyword, scale) in [
            ("DCSIZC", scales.coordinate),
            ("DCSIZF", scales.force),
            ("DCSIZS", scales.stress),
            ("DCSIZV", scales.velocity),
            ("DCSIZD", scales.displacement),
            ("DCSIZA", scales.aperture.log10()),
        ] {
            if scale == 0.0 || !scale.is_finite() {
                let value = if keyword == "DCSIZA" { scales.aperture } else { scale };
                notices.push(YmNotice::UselessScale { keyword, value: value.to_string() });
            }
        }
        let times = SnapshotTimes {
            first_step: values.integer("YDC/NCSTEP"),
            first_time: values.real("YDC/DCTIME"),
            time_step: values.real("YDC/DCSTEC"),
            interval: values.integer("YDC/ICOUTF"),
            first_number: values.integer("YDC/ICOUTI"),
        };
        let times = (times.interval > 0).then_some(times);
        if times.is_none() {
            notices.push(YmNotice::NoTimes);
        }
        Self { scales, times, notices }
    }

    /// The time of a snapshot, s; its number if the deck does not say.
    #[must_use]
    pub fn time(&self, number: u64) -> f64 {
        self.times.map_or(number as f64, |times| times.time(number))
    }
}
