//! The title: the first ten words of a d3plot file.

/// Bytes of a title.
const LENGTH: usize = 40;
/// Where the bracketed start date begins.
const DATE_AT: usize = 27;

/// The day a run was started, as it appears in a title.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StartDate {
    /// Day of the month, 1 to 31.
    pub day: u8,
    /// Month, 1 to 12.
    pub month: u8,
    /// Year, four digits.
    pub year: u16,
}

/// The 40 bytes of a title: output name, padded with blanks, the start date in brackets from
/// byte 27 to 38, a zero byte at the end.
///
/// ```
/// use yformat::d3plot::{StartDate, Title};
/// let title = Title::new("actual", StartDate { day: 27, month: 7, year: 2021 });
/// assert_eq!(title.as_bytes(), b"actual                     [27/07/2021]\0");
/// assert_eq!(title.text(), "actual                     [27/07/2021]");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Title([u8; LENGTH]);

impl Title {
    /// The title of a run named `name`; what a long name holds beyond 27 bytes gives way to the
    /// date.
    pub fn new(name: &str, date: StartDate) -> Self {
        let stamp =
            format!("[{:02}/{:02}/{:04}]\0", date.day % 100, date.month % 100, date.year % 10_000);
        let mut bytes = [b' '; LENGTH];
        for (slot, byte) in bytes[..DATE_AT].iter_mut().zip(name.bytes()) {
            *slot = byte;
        }
        for (slot, byte) in bytes[DATE_AT..].iter_mut().zip(stamp.bytes()) {
            *slot = byte;
        }
        Self(bytes)
    }

    /// A title taken as it is.
    pub fn from_bytes(bytes: [u8; LENGTH]) -> Self {
        Self(bytes)
    }

    /// The 40 bytes.
    pub fn as_bytes(&self) -> &[u8; LENGTH] {
        &self.0
    }

    /// The title up to its zero byte; bytes that are not UTF-8 become replacement characters.
    pub fn text(&self) -> String {
        let end = self.0.iter().position(|&b| b == 0).unwrap_or(LENGTH);
        String::from_utf8_lossy(&self.0[..end]).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_date_wins_over_a_long_name() {
        let date = StartDate { day: 1, month: 12, year: 2026 };
        let title = Title::new("a_name_of_more_than_twenty_seven_bytes", date);
        assert_eq!(title.text(), "a_name_of_more_than_twenty_[01/12/2026]");
        assert_eq!(title.as_bytes()[39], 0);
    }
}
