//! Snapshots of the classic dialect: the `.ym` text files.
//!
//! The first line is `CODED`; each further line is one record in digits of base 90: a triangle, a
//! joint, a model boundary or an acoustic source. Reals are divided by a [`Scales`] of the deck,
//! clamped to -1 ... 1 and cut to a fixed number of digits, so that a snapshot holds less than the
//! program knew: with the usual four digits a value is right to 3e-8 of its scale, with two to
//! 2.5e-4. Zero is no exception, it comes back as `-scale / (90^digits - 1)`.
//!
//! [`Snapshot`] keeps the digits as integers, so that what was read is written back unchanged;
//! [`CodedRecord::decode`] gives the reals. [`SnapshotWriter`] goes from reals to text as the
//! original does, operation for operation.
//!
//! ```
//! use yformat::ym::{AcousticSource, Digits, Record, Scales, Snapshot, SnapshotWriter};
//!
//! let scales = Scales { coordinate: 10.0, ..Scales::default() };
//! let mut writer = SnapshotWriter::new(Vec::new(), Digits::new(4).unwrap(), scales)?;
//! writer.write(&Record::AcousticSource(AcousticSource { position: [1.0, 2.5], magnitude: 3.0 }))?;
//! let text = writer.into_inner();
//! assert_eq!(text, b"CODED\n4-6000??/$?/[+???(???/???/???/???/\n");
//!
//! let snapshot = Snapshot::parse("wall0.ym", &text)?;
//! let Record::AcousticSource(source) = snapshot.records[0].decode(&scales) else { panic!() };
//! assert!((source.position[1] - 2.5).abs() < 10.0 * Digits::new(4).unwrap().quantum());
//! assert_eq!(snapshot.to_bytes(), text);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Which records follow which: for each property set in turn the triangles of that set, or, if it
//! is a set of joints, **all** joints and boundaries and then all acoustic sources of the model. With
//! several joint sets these are therefore repeated. (outputs.md 1)

mod coded;
mod digits;
mod error;
mod reader;
mod record;
mod scales;
mod writer;

pub use coded::{CodedRecord, RecordKind};
pub use digits::Digits;
pub use error::{YmError, YmProblem};
pub use reader::{LineEnd, Snapshot};
pub use record::{AcousticSource, BoundaryJoint, FractureJoint, MeanVelocity, Record, Triangle};
pub use scales::Scales;
pub use writer::SnapshotWriter;

/// First line of every snapshot.
const HEADING: &[u8] = b"CODED";
