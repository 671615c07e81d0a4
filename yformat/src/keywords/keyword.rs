//! One keyword and the small language in which the tables are written.

/// Whether a keyword holds integers or reals; they are scanned by different rules.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::{NumberKind, find};
///
/// assert_eq!(find(Dialect::Split, "YDC/MCSTEP").unwrap().number, NumberKind::Integer);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum NumberKind {
    /// Decimal integers.
    Integer,
    /// Decimal reals.
    Real,
}

/// Declared length of one index of an array.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::{Extent, find};
///
/// let extents = find(Dialect::Split, "YDPM/I2PMIJ").unwrap().extents;
/// assert_eq!(extents, &[Extent::Fixed(3), Extent::Size("MPMROW")]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Extent {
    /// The present value of a size keyword of the same database.
    Size(&'static str),
    /// Always this long.
    Fixed(usize),
}

/// An array that the program makes when a size keyword is read, with a value of its own.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::find;
///
/// let created = find(Dialect::Split, "YDPN/D1PNAX").unwrap().created.unwrap();
/// assert_eq!((created.by, created.value), ("MPNSET", 1.0));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Created {
    /// The size keyword of the same database.
    pub by: &'static str,
    /// What every entry then holds.
    pub value: f64,
}

/// What the program does with a scalar's value as soon as it is read.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::{Adjustment, find};
///
/// let keyword = find(Dialect::Split, "YDC/ICOUTF").unwrap();
/// assert_eq!(keyword.adjustment, Adjustment::NonPositiveTo(10));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Adjustment {
    /// Takes it as it is.
    Keep,
    /// Refuses negative values.
    RejectNegative,
    /// Replaces negative values.
    NegativeTo(i64),
    /// Replaces negative values and zero.
    NonPositiveTo(i64),
    /// Replaces everything but zero.
    NonZeroTo(i64),
    /// Replaces everything outside the list.
    OutsideTo(&'static [i64], i64),
}

/// What becomes of the value.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::{Role, find};
///
/// assert_eq!(find(Dialect::Split, "YDN/D1NMCT").unwrap().role, Role::Recomputed);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// The program cannot run without it.
    Required,
    /// It has an effect.
    Used,
    /// It has an effect in 3D only.
    Only3d,
    /// The program computes it anew, what the deck gives is lost.
    Recomputed,
    /// It is read and never looked at.
    NoEffect,
    /// Programs that read it use it, Ypsilon does not look at it.
    Ignored,
    /// It asks for what is not simulated, told in these words: decks in which it is above 0
    /// (integers) or other than 0 (reals) are refused.
    Refused(&'static str),
}

/// All that is known about one keyword of one dialect.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::{self, Extent};
///
/// let keyword = keywords::find(Dialect::Split, "YDN/D2NCC").unwrap();
/// assert_eq!(keyword.path(), "/YD/YDN/D2NCC");
/// assert_eq!(keyword.extents, &[Extent::Size("MNODIM"), Extent::Size("MNOPO")]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Keyword {
    /// Database such as `YDC`.
    pub database: &'static str,
    /// Name such as `MCSTEP`.
    pub name: &'static str,
    /// How many characters of the name are compared; what follows them is ignored.
    pub match_length: usize,
    /// Integers or reals.
    pub number: NumberKind,
    /// Declared lengths, slowest index of the documentation first; empty for a scalar.
    pub extents: &'static [Extent],
    /// Value of a scalar that the deck does not give. (Integers are small enough to be exact here.)
    pub default: f64,
    /// Whether `default` is the original's: false where the original computes with whatever its
    /// memory holds.
    pub default_known: bool,
    /// What entries hold that an array keyword leaves out.
    pub fill: f64,
    /// How the array comes to be if its keyword is absent.
    pub created: Option<Created>,
    /// What the program does with a scalar right after reading.
    pub adjustment: Adjustment,
    /// What becomes of the value.
    pub role: Role,
    /// Unit, `-` where there is none.
    pub unit: &'static str,
    /// One line for the keyword reference.
    pub meaning: &'static str,
    /// The keyword in whose place the value is really stored (a slip of the original).
    pub stores_into: Option<&'static str>,
    /// Y-Geo reads a second array of the same form right behind and uses it as scratch space.
    pub scratch_follows: bool,
    /// The third size of a rank-3 array may be absent, as all known writers leave it out.
    pub short_header: bool,
    /// Values may be `nan` or infinite: the program writes this state as it is into its restart
    /// decks, entries that it never defined included.
    pub may_be_undefined: bool,
}

impl Keyword {
    /// Number of indices: 0 for a scalar.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.extents.len()
    }

    /// The word that a deck spells, `/YD/YDC/MCSTEP`.
    #[must_use]
    pub fn path(&self) -> String {
        format!("/YD/{}/{}", self.database, self.name)
    }

    /// Whether a keyword of the same database sizes this array.
    #[must_use]
    pub fn is_sized_by(&self, size: &str) -> bool {
        self.extents.iter().any(|extent| matches!(extent, Extent::Size(name) if *name == size))
    }

    const fn new(name: &'static str, number: NumberKind, extents: &'static [Extent]) -> Self {
        Keyword {
            database: "",
            name,
            match_length: name.len(),
            number,
            extents,
            default: 0.0,
            default_known: true,
            fill: match number {
                NumberKind::Integer => -1.0,
                NumberKind::Real => 0.0,
            },
            created: None,
            adjustment: Adjustment::Keep,
            role: Role::Used,
            unit: "-",
            meaning: "",
            stores_into: None,
            scratch_follows: false,
            short_header: false,
            may_be_undefined: false,
        }
    }

    pub(super) const fn compared_over(mut self, characters: usize) -> Self {
        self.match_length = characters;
        self
    }

    pub(super) const fn indeterminate(mut self) -> Self {
        self.default_known = false;
        self
    }

    pub(super) const fn fill(mut self, value: f64) -> Self {
        self.fill = value;
        self
    }

    pub(super) const fn created_by(mut self, by: &'static str, value: f64) -> Self {
        self.created = Some(Created { by, value });
        self
    }

    pub(super) const fn adjusted(mut self, adjustment: Adjustment) -> Self {
        self.adjustment = adjustment;
        self
    }

    pub(super) const fn required(mut self) -> Self {
        self.role = Role::Required;
        self
    }

    pub(super) const fn no_effect(mut self) -> Self {
        self.role = Role::NoEffect;
        self
    }

    pub(super) const fn ignored(mut self) -> Self {
        self.role = Role::Ignored;
        self
    }

    pub(super) const fn refused(mut self, what: &'static str) -> Self {
        self.role = Role::Refused(what);
        self
    }

    pub(super) const fn recomputed(mut self) -> Self {
        self.role = Role::Recomputed;
        self
    }

    pub(super) const fn only_3d(mut self) -> Self {
        self.role = Role::Only3d;
        self
    }

    pub(super) const fn stores_into(mut self, name: &'static str) -> Self {
        self.stores_into = Some(name);
        self
    }

    pub(super) const fn scratch_follows(mut self) -> Self {
        self.scratch_follows = true;
        self
    }

    pub(super) const fn short_header(mut self) -> Self {
        self.short_header = true;
        self
    }

    pub(super) const fn may_be_undefined(mut self) -> Self {
        self.may_be_undefined = true;
        self
    }

    const fn described(mut self, unit: &'static str, meaning: &'static str) -> Self {
        self.unit = unit;
        self.meaning = meaning;
        self
    }
}

/// An integer scalar.
pub(super) const fn integer(name: &'static str, default: i32, meaning: &'static str) -> Keyword {
    let mut keyword = Keyword::new(name, NumberKind::Integer, &[]).described("-", meaning);
    keyword.default = default as f64;
    keyword
}

/// A real scalar.
pub(super) const fn real(
    name: &'static str,
    default: f64,
    unit: &'static str,
    meaning: &'static str,
) -> Keyword {
    let mut keyword = Keyword::new(name, NumberKind::Real, &[]).described(unit, meaning);
    keyword.default = default;
    keyword
}

/// An integer array; entries that are not given hold −1.
pub(super) const fn integers(
    name: &'static str,
    extents: &'static [Extent],
    meaning: &'static str,
) -> Keyword {
    Keyword::new(name, NumberKind::Integer, extents).described("-", meaning)
}

/// A real array; entries that are not given hold 0.
pub(super) const fn reals(
    name: &'static str,
    extents: &'static [Extent],
    unit: &'static str,
    meaning: &'static str,
) -> Keyword {
    Keyword::new(name, NumberKind::Real, extents).described(unit, meaning)
}

/// Puts the keywords into a database.
pub(super) const fn of<const N: usize>(
    database: &'static str,
    mut keywords: [Keyword; N],
) -> [Keyword; N] {
    let mut i = 0;
    while i < N {
        keywords[i].database = database;
        i += 1;
    }
    keywords
}
