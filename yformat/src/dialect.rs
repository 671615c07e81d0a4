//! The dialects of the deck language, and how to tell them apart.

use std::fmt;
use std::str::FromStr;

use crate::deck::words::DeckWords;
use crate::keywords;

/// A member of the Y family with its own set of keywords.
///
/// ```
/// use yformat::dialect::Dialect;
///
/// assert_eq!("y-geo".parse(), Ok(Dialect::YGeo));
/// assert_eq!(Dialect::Split.to_string(), "split");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Dialect {
    /// The 2D/3D program of Queen Mary with separate element, node and joint sets.
    Split,
    /// The book program with the joints of Imperial College: one property table.
    Classic,
    /// Y-Geo of Toronto.
    YGeo,
    /// The `.Y3D` decks of VGW and Solidity.
    Y3d,
}

impl Dialect {
    /// All dialects; where a deck fits several equally well, the first of them is taken.
    pub const ALL: [Dialect; 4] = [Dialect::Split, Dialect::Classic, Dialect::YGeo, Dialect::Y3d];

    /// Name for the command line and messages.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Dialect::Split => "split",
            Dialect::Classic => "classic",
            Dialect::YGeo => "y-geo",
            Dialect::Y3d => "y3d",
        }
    }

    /// Whether `$YINCL` is known.
    #[must_use]
    pub fn has_include(self) -> bool {
        self == Dialect::Split
    }
}

impl fmt::Display for Dialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A dialect name that nobody knows.
///
/// ```
/// use yformat::dialect::Dialect;
///
/// let error = "fortran".parse::<Dialect>().unwrap_err();
/// assert!(error.to_string().contains("split, classic, y-geo and y3d"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("unknown dialect `{0}`; known are split, classic, y-geo and y3d")]
pub struct UnknownDialect(String);

impl FromStr for Dialect {
    type Err = UnknownDialect;

    fn from_str(name: &str) -> Result<Self, UnknownDialect> {
        let wanted = name.to_lowercase().replace('-', "");
        let found =
            Dialect::ALL.into_iter().find(|dialect| dialect.name().replace('-', "") == wanted);
        found.ok_or_else(|| UnknownDialect(name.to_owned()))
    }
}

/// What [`detect`] found.
///
/// ```
/// let detection = yformat::dialect::detect("a.y", b"/YD/YDC/MCSTEP 5\n");
/// assert!(!detection.certain);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Detection {
    /// The dialect that knows most of the deck's keywords.
    pub dialect: Dialect,
    /// Whether the deck really says so: false if it has only keywords that classic and split decks
    /// share.
    pub certain: bool,
}

/// Tells the dialect of a deck from its keywords: the one that knows most of them.
///
/// A keyword that another dialect owns does not overrule the rest of the deck; the parser then
/// reports that word as the one that does not belong.
///
/// ```
/// use yformat::dialect::{Dialect, detect};
///
/// let detection = detect("a.y", b"/YD/YDPE/MPROP 1 /YD/YDPE/D1PEPT 1 1e9\n");
/// assert_eq!(detection.dialect, Dialect::Split);
/// assert!(detection.certain);
/// ```
#[must_use]
pub fn detect(name: &str, bytes: &[u8]) -> Detection {
    let mut votes = [0usize; Dialect::ALL.len()];
    for word in DeckWords::new(bytes) {
        for (vote, dialect) in votes.iter_mut().zip(Dialect::ALL) {
            let known = match word.starts_with(b"$YINCL") {
                true => dialect.has_include(),
                false => matches!(keywords::match_word(dialect, word), Some((_, Some(_)))),
            };
            *vote += usize::from(known);
        }
    }
    let most = votes.iter().copied().max().unwrap_or(0);
    let best: Vec<Dialect> =
        Dialect::ALL.into_iter().zip(votes).filter(|(_, n)| *n == most).map(|(d, _)| d).collect();
    let named_y3d = name.to_ascii_lowercase().ends_with(".y3d");
    let dialect = match best.first() {
        _ if named_y3d && best.contains(&Dialect::Y3d) => Dialect::Y3d,
        Some(dialect) => *dialect,
        None => Dialect::Split,
    };
    // Split and Y-Geo share the split databases: a deck without a keyword of either is a split
    // deck, Y-Geo would lack its mandatory ones. Split and classic decks in contrast share nothing
    // that could be computed.
    let certain = !(best.contains(&Dialect::Split) && best.contains(&Dialect::Classic));
    Detection { dialect, certain: certain || (named_y3d && dialect == Dialect::Y3d) }
}
