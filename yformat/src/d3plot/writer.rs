//! Streams a family to disk.

use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

use super::blocks::Blocks;
use super::control::ControlBlock;
use super::encode;
use super::error::WriteError;
use super::family::{END_OF_FILE_MARKER, member_path};
use super::geometry::Geometry;
use super::layout::StateLayout;
use super::state::{State, StateView};
use crate::part_file::{Mark, PartFile};

/// Writes a family, state after state.
///
/// Every file is written as `<name>.part` beside its final place and renamed when it is
/// complete: at the roll-over to the next file, or by [`FamilyWriter::finish`]. A run that dies
/// leaves the last file under its `.part` name, whole states only as far as the operating
/// system took them. Each state is written block by block, from one buffer that is kept.
#[derive(Debug)]
pub struct FamilyWriter {
    first: PathBuf,
    control: ControlBlock,
    layout: StateLayout,
    states_per_file: u64,
    file: PartFile,
    member: u32,
    states_in_file: u64,
    completed: Vec<PathBuf>,
    block: Vec<u8>,
}

/// How far a family was written: enough for another run to go on from there.
#[derive(Debug, Clone, PartialEq)]
pub struct FamilyMark {
    /// The control block.
    pub control: ControlBlock,
    /// Number of the last file.
    pub member: u32,
    /// States in it.
    pub states_in_file: u64,
    /// How far it was written.
    pub file: Mark,
}

/// What [`FamilyWriter::finish`] left on disk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finished {
    /// The files of the family, in order.
    pub files: Vec<PathBuf>,
    /// Files of an earlier, longer family of the same name that follow this one. Programs that
    /// go by file names would take them for its continuation.
    pub stale: Vec<PathBuf>,
}

impl FamilyWriter {
    /// Starts a family whose first file is to be `path`, and writes control block and geometry.
    ///
    /// `states_per_file` is [`super::states_per_file`] for Y's own rule; 0 counts as 1.
    pub fn create(
        path: &Path,
        control: ControlBlock,
        geometry: &Geometry,
        states_per_file: u64,
    ) -> Result<Self, WriteError> {
        let layout = StateLayout::new(&control)?;
        encode::check_geometry(&layout, geometry)?;
        let mut file = PartFile::create(path).map_err(WriteError::io(path))?;
        let mut block = Vec::new();
        let mut out = Blocks::new(&mut file, &mut block);
        out.put_all(&control.to_bytes());
        encode::geometry(&mut out, geometry);
        out.finish().map_err(WriteError::io(path))?;
        Ok(Self {
            first: path.to_path_buf(),
            control,
            layout,
            states_per_file: states_per_file.max(1),
            file,
            member: 0,
            states_in_file: 0,
            completed: Vec::new(),
            block,
        })
    }

    /// Goes on with a family whose first file is `path` and which an earlier run has written up
    /// to `mark`; what is there beyond is cut off.
    ///
    /// # Errors
    /// If a file of the family is missing or does not hold what had been written.
    pub fn resume(
        path: &Path,
        states_per_file: u64,
        mark: &FamilyMark,
    ) -> Result<Self, WriteError> {
        let layout = StateLayout::new(&mark.control)?;
        let mut completed = Vec::new();
        for member in 0..mark.member {
            let file = member_path(path, member);
            if !file.is_file() {
                let source = io::Error::new(io::ErrorKind::NotFound, "the file is missing");
                return Err(WriteError::io(&file)(source));
            }
            completed.push(file);
        }
        let last = member_path(path, mark.member);
        let file = PartFile::resume(&last, &mark.file).map_err(WriteError::io(&last))?;
        Ok(Self {
            first: path.to_path_buf(),
            control: mark.control,
            layout,
            states_per_file: states_per_file.max(1),
            file,
            member: mark.member,
            states_in_file: mark.states_in_file,
            completed,
            block: Vec::new(),
        })
    }

    /// How far the family has been written; that much is on the disk then.
    ///
    /// # Errors
    /// If the system cannot put it there.
    pub fn mark(&mut self) -> Result<FamilyMark, WriteError> {
        let file = self.file.mark().map_err(WriteError::io(self.file.temporary_path()))?;
        let (member, states_in_file) = (self.member, self.states_in_file);
        Ok(FamilyMark { control: self.control, member, states_in_file, file })
    }

    /// Appends a state, rounded to single precision. A state with arrays of wrong lengths is
    /// refused and nothing of it is written.
    pub fn write_state(&mut self, state: &StateView<'_>) -> Result<(), WriteError> {
        encode::check_view(&self.layout, state)?;
        let layout = self.layout;
        self.append(|out| encode::view(out, &layout, state))
    }

    /// Appends a state as it was read from another family, bit for bit.
    pub fn copy_state(&mut self, state: &State) -> Result<(), WriteError> {
        encode::check_recorded(&self.layout, state)?;
        self.append(|out| encode::recorded(out, state))
    }

    /// Completes the last file.
    pub fn finish(mut self) -> Result<Finished, WriteError> {
        self.completed.push(complete(self.file)?);
        let stale = (self.member + 1..)
            .map(|member| member_path(&self.first, member))
            .take_while(|path| path.exists())
            .collect();
        Ok(Finished { files: self.completed, stale })
    }

    /// Writes a record, in the next file when this one is full.
    fn append(&mut self, encode: impl FnOnce(&mut Blocks<'_>)) -> Result<(), WriteError> {
        if self.states_in_file == self.states_per_file {
            self.roll_over()?;
        }
        let mut out = Blocks::new(&mut self.file, &mut self.block);
        encode(&mut out);
        out.finish().map_err(WriteError::io(self.file.temporary_path()))?;
        self.states_in_file += 1;
        Ok(())
    }

    fn roll_over(&mut self) -> Result<(), WriteError> {
        let marker = END_OF_FILE_MARKER.to_le_bytes();
        self.file.write_all(&marker).map_err(WriteError::io(self.file.temporary_path()))?;
        self.member += 1;
        let path = member_path(&self.first, self.member);
        let next = PartFile::create(&path).map_err(WriteError::io(&path))?;
        let full = std::mem::replace(&mut self.file, next);
        self.completed.push(complete(full)?);
        self.states_in_file = 0;
        Ok(())
    }
}

fn complete(file: PartFile) -> Result<PathBuf, WriteError> {
    let refused = WriteError::io(file.path());
    file.complete().map_err(refused)
}
