//! Reads a family from disk or memory.

use std::fmt;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use super::control::ControlBlock;
use super::decode;
use super::error::ReadError;
use super::family::{END_OF_FILE_MARKER, member_path};
use super::geometry::Geometry;
use super::layout::StateLayout;
use super::state::State;

/// Something about a family that is worth telling its user but does not prevent reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Notice {
    /// The file ends within a state, as when the program was killed. The whole states before
    /// are there.
    TruncatedState {
        /// The file.
        path: PathBuf,
        /// Bytes of the last, partial state.
        bytes: u64,
        /// Bytes a whole state has.
        expected: u64,
    },
    /// A further file with the name of the next member is there, but this one does not end
    /// with the marker that announces it; it was left out.
    FollowerIgnored {
        /// The file left out.
        path: PathBuf,
    },
}

impl fmt::Display for Notice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TruncatedState { path, bytes, expected } => write!(
                f,
                "{} ends within a state ({bytes} of {expected} bytes); the whole states before it are read",
                path.display()
            ),
            Self::FollowerIgnored { path } => write!(
                f,
                "{} is left out: the file before it does not say that it is continued",
                path.display()
            ),
        }
    }
}

/// One file of the family.
#[derive(Debug)]
struct Member<R> {
    path: PathBuf,
    source: R,
    /// Byte where its first state begins.
    first_state: u64,
    /// Whole states in it.
    states: usize,
}

/// Reads the states of a family in any order.
///
/// Counts in the file are believed only as far as the file is long: a damaged header leads to
/// an error, never to a huge allocation.
#[derive(Debug)]
pub struct FamilyReader<R = File> {
    control: ControlBlock,
    layout: StateLayout,
    geometry: Geometry,
    members: Vec<Member<R>>,
    times: Vec<f32>,
    notices: Vec<Notice>,
    buffer: Vec<u8>,
}

impl FamilyReader<File> {
    /// Opens the family whose first file is `path`, and every file that continues it.
    pub fn open(path: &Path) -> Result<Self, ReadError> {
        let file = File::open(path).map_err(at(path))?;
        let mut reader = Self::start(path.to_path_buf(), file)?;
        let mut index = 1;
        loop {
            let next = member_path(path, index);
            if !next.is_file() {
                return Ok(reader);
            }
            if !reader.is_continued()? {
                reader.notices.push(Notice::FollowerIgnored { path: next });
                return Ok(reader);
            }
            let file = File::open(&next).map_err(at(&next))?;
            reader.add(next, file, 0)?;
            index += 1;
        }
    }
}

impl<R: Read + Seek> FamilyReader<R> {
    /// Opens a family given as its files in order, for instance [`io::Cursor`]s. Files after
    /// one without end marker are left out.
    pub fn from_sources(sources: impl IntoIterator<Item = R>) -> Result<Self, ReadError> {
        let mut sources = sources.into_iter();
        let first = sources.next().ok_or(ReadError::Empty)?;
        let mut reader = Self::start(PathBuf::from("file 0"), first)?;
        for (index, source) in sources.enumerate() {
            let name = PathBuf::from(format!("file {}", index + 1));
            if !reader.is_continued()? {
                reader.notices.push(Notice::FollowerIgnored { path: name });
                break;
            }
            reader.add(name, source, 0)?;
        }
        Ok(reader)
    }

    /// The control block.
    pub fn control(&self) -> &ControlBlock {
        &self.control
    }

    /// The layout of the states.
    pub fn layout(&self) -> &StateLayout {
        &self.layout
    }

    /// Initial coordinates and connectivity.
    pub fn geometry(&self) -> &Geometry {
        &self.geometry
    }

    /// How many whole states there are.
    pub fn state_count(&self) -> usize {
        self.times.len()
    }

    /// The times of the states.
    pub fn times(&self) -> &[f32] {
        &self.times
    }

    /// How many whole states each file holds.
    pub fn states_per_member(&self) -> Vec<usize> {
        self.members.iter().map(|m| m.states).collect()
    }

    /// What is worth telling about the family.
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// State number `index`, from 0.
    pub fn state(&mut self, index: usize) -> Result<State, ReadError> {
        let mut state = State::default();
        self.read_state(index, &mut state)?;
        Ok(state)
    }

    /// Reads state number `index` into `state`, whose memory is used again.
    pub fn read_state(&mut self, index: usize, state: &mut State) -> Result<(), ReadError> {
        let count = self.times.len();
        let no_such_state = || ReadError::NoSuchState { index, count };
        let bytes = self.layout.state_bytes();
        let mut in_member = index;
        let member = self
            .members
            .iter_mut()
            .find(|member| {
                let here = in_member < member.states;
                if !here {
                    in_member -= member.states;
                }
                here
            })
            .ok_or_else(no_such_state)?;
        let start = member.first_state + bytes * in_member as u64;
        read_at(member, start, bytes, &mut self.buffer)?;
        decode::state(&self.layout, &self.buffer, state);
        Ok(())
    }

    fn start(path: PathBuf, mut source: R) -> Result<Self, ReadError> {
        let available = source.seek(SeekFrom::End(0)).map_err(at(&path))?;
        let short = |section, needed| ReadError::TooShort { section, needed, available };
        if available < ControlBlock::BYTES as u64 {
            return Err(short("control block", ControlBlock::BYTES as u64));
        }
        let mut head = [0; ControlBlock::BYTES];
        source.seek(SeekFrom::Start(0)).map_err(at(&path))?;
        source.read_exact(&mut head).map_err(at(&path))?;
        let control = ControlBlock::from_bytes(&head);
        let layout = StateLayout::new(&control)?;
        let first_state = ControlBlock::BYTES as u64 + 4 * layout.geometry_words();
        if available < first_state {
            return Err(short("geometry", first_state));
        }
        let mut reader = Self {
            control,
            layout,
            geometry: Geometry::default(),
            members: Vec::new(),
            times: Vec::new(),
            notices: Vec::new(),
            buffer: Vec::new(),
        };
        reader.add(path, source, first_state)?;
        if let Some(first) = reader.members.first_mut() {
            let bytes = 4 * layout.geometry_words();
            let start = ControlBlock::BYTES as u64;
            read_at(first, start, bytes, &mut reader.buffer)?;
            reader.geometry = decode::geometry(&layout, &reader.buffer);
        }
        Ok(reader)
    }

    /// Adds a file and finds its states.
    fn add(&mut self, path: PathBuf, mut source: R, first_state: u64) -> Result<(), ReadError> {
        let length = source.seek(SeekFrom::End(0)).map_err(at(&path))?;
        let record = self.layout.state_bytes();
        let mut states = 0;
        let mut start = first_state;
        loop {
            let left = length.saturating_sub(start);
            if left < 4 {
                self.note_truncation(&path, left, record);
                break;
            }
            let mut word = [0; 4];
            source.seek(SeekFrom::Start(start)).map_err(at(&path))?;
            source.read_exact(&mut word).map_err(at(&path))?;
            let time = f32::from_le_bytes(word);
            if time == END_OF_FILE_MARKER {
                break;
            }
            if left < record {
                self.note_truncation(&path, left, record);
                break;
            }
            self.times.push(time);
            states += 1;
            start += record;
        }
        self.members.push(Member { path, source, first_state, states });
        Ok(())
    }

    fn note_truncation(&mut self, path: &Path, bytes: u64, expected: u64) {
        if bytes > 0 {
            self.notices.push(Notice::TruncatedState { path: path.to_path_buf(), bytes, expected });
        }
    }

    /// Whether the last file so far ends with the marker.
    fn is_continued(&mut self) -> Result<bool, ReadError> {
        let record = self.layout.state_bytes();
        let Some(last) = self.members.last_mut() else {
            return Ok(false);
        };
        let end = last.first_state + record * last.states as u64;
        let length = last.source.seek(SeekFrom::End(0)).map_err(at(&last.path))?;
        if length < end + 4 {
            return Ok(false);
        }
        read_at(last, end, 4, &mut self.buffer)?;
        Ok(self.buffer == END_OF_FILE_MARKER.to_le_bytes())
    }
}

/// Reads `bytes` from `start` on; the caller has compared them with the length of the file.
fn read_at<R: Read + Seek>(
    member: &mut Member<R>,
    start: u64,
    bytes: u64,
    buffer: &mut Vec<u8>,
) -> Result<(), ReadError> {
    let path = &member.path;
    let bytes = usize::try_from(bytes)
        .map_err(|_| at(path)(io::Error::from(io::ErrorKind::OutOfMemory)))?;
    buffer.clear();
    buffer.resize(bytes, 0);
    let source = &mut member.source;
    source.seek(SeekFrom::Start(start)).map_err(at(path))?;
    source.read_exact(buffer).map_err(at(path))
}

fn at(path: &Path) -> impl Fn(io::Error) -> ReadError + '_ {
    |source| ReadError::Io { path: path.to_path_buf(), source }
}
