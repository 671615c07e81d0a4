//! Records as the file holds them: integers.

use super::digits::digit_of;
use super::{Digits, Record, Scales};

/// What a record describes, with what decides its length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RecordKind {
    /// A triangle of an elastic property set, which has a contact force.
    Triangle,
    /// A triangle of a softening or rigid set, which has none.
    TriangleWithoutForce,
    /// A fracture.
    FractureJoint,
    /// A boundary edge.
    BoundaryJoint,
    /// An acoustic source.
    AcousticSource,
}

impl RecordKind {
    const ALL: [Self; 5] = [
        Self::Triangle,
        Self::TriangleWithoutForce,
        Self::FractureJoint,
        Self::BoundaryJoint,
        Self::AcousticSource,
    ];

    /// The type number that a line of this kind begins with.
    #[must_use]
    pub fn type_number(self) -> u64 {
        match self {
            Self::Triangle | Self::TriangleWithoutForce => 1,
            Self::FractureJoint => 3,
            Self::BoundaryJoint => 5,
            Self::AcousticSource => 6,
        }
    }

    /// How many reals it has.
    #[must_use]
    pub fn reals(self) -> usize {
        match self {
            Self::Triangle => 14,
            Self::TriangleWithoutForce => 12,
            Self::FractureJoint | Self::BoundaryJoint => 16,
            Self::AcousticSource => 7,
        }
    }

    /// The count field: the reals, the type and the two characters before it.
    pub(super) fn count(self) -> u8 {
        self.reals() as u8 + 3
    }

    /// The kind of this type number and count.
    pub(super) fn of(type_number: u64, count: u8) -> Option<Self> {
        let fits = |kind: &Self| kind.type_number() == type_number && kind.count() == count;
        Self::ALL.into_iter().find(fits)
    }

    /// The counts that records of this type may have; none for an unknown type.
    pub(super) fn counts(type_number: u64) -> Vec<u8> {
        let same = Self::ALL.into_iter().filter(|kind| kind.type_number() == type_number);
        same.map(Self::count).collect()
    }
}

/// One line of a snapshot, as integers: nothing is lost.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct CodedRecord {
    kind: RecordKind,
    digits: Digits,
    /// As many count as the kind has reals; 0 beyond.
    numbers: [u64; 16],
}

impl CodedRecord {
    /// A record of integers; those beyond [`RecordKind::reals`] are ignored.
    pub(super) fn new(
        kind: RecordKind,
        digits: Digits,
        numbers: impl IntoIterator<Item = u64>,
    ) -> Self {
        let mut kept = [0; 16];
        kept.iter_mut().take(kind.reals()).zip(numbers).for_each(|(slot, number)| *slot = number);
        Self { kind, digits, numbers: kept }
    }

    /// Codes a record.
    #[must_use]
    pub fn encode(record: &Record, digits: Digits, scales: &Scales) -> Self {
        let kind = match record {
            Record::Triangle(triangle) if triangle.contact_force.is_some() => RecordKind::Triangle,
            Record::Triangle(_) => RecordKind::TriangleWithoutForce,
            Record::FractureJoint(_) => RecordKind::FractureJoint,
            Record::BoundaryJoint(_) => RecordKind::BoundaryJoint,
            Record::AcousticSource(_) => RecordKind::AcousticSource,
        };
        let units = record.to_units(scales);
        Self::new(kind, digits, units.as_slice().iter().map(|&unit| digits.encode(unit)))
    }

    /// The reals in SI units.
    #[must_use]
    pub fn decode(&self, scales: &Scales) -> Record {
        let units = self.numbers.map(|number| self.digits.decode(number));
        match self.kind {
            RecordKind::Triangle | RecordKind::TriangleWithoutForce => {
                Record::triangle(units.get(..self.kind.reals()).unwrap_or_default(), scales)
            }
            RecordKind::FractureJoint => Record::fracture_joint(&units, scales),
            RecordKind::BoundaryJoint => Record::boundary_joint(&units, scales),
            RecordKind::AcousticSource => Record::acoustic_source(&units, scales),
        }
    }

    /// What it describes.
    #[must_use]
    pub fn kind(&self) -> RecordKind {
        self.kind
    }

    /// Digits per number.
    #[must_use]
    pub fn digits(&self) -> Digits {
        self.digits
    }

    /// The integers in the order of the line.
    #[must_use]
    pub fn numbers(&self) -> &[u64] {
        self.numbers.get(..self.kind.reals()).unwrap_or_default()
    }

    /// A real of the line, counted from 0, in units of its scale: -1 to 1.
    #[must_use]
    pub fn unit(&self, index: usize) -> Option<f64> {
        self.numbers().get(index).map(|&number| self.digits.decode(number))
    }

    /// Appends the line, without line end.
    pub(super) fn push_line(&self, line: &mut Vec<u8>) {
        line.push(digit_of(self.digits.get() as u8));
        line.push(digit_of(self.kind.count()));
        self.digits.push(self.kind.type_number(), line);
        self.numbers().iter().for_each(|&number| self.digits.push(number, line));
    }
}
