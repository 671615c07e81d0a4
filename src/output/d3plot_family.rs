//! A d3plot family being written, in the plane or in space.

use super::{Background, FilePosition, OutputError, OutputNames, background::lock, decode, encode};
use serde::{Deserialize, Serialize};
use std::{
    io,
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
};
use yformat::d3plot::{
    ControlBlock, FamilyMark, FamilyWriter, Geometry, StartDate, StateView, WriteError,
    states_per_file,
};

/// What `--formats` calls the files.
pub(super) const KIND: &str = "d3plot";

/// A family, opened at the first state, and what it is called.
pub(super) struct Family {
    pub names: OutputNames,
    background: Background,
    /// Date of the title.
    pub start: StartDate,
    /// Whether the control block is exactly the original's.
    pub legacy: bool,
    open: Option<OpenFamily>,
}

/// The files, and what of the scene they show.
pub(super) struct OpenFamily {
    writer: Arc<Mutex<FamilyWriter>>,
    per_file: u64,
    /// Elements shown: chosen at the first state, kept to the end.
    elements: Vec<u32>,
    /// Nodes announced in the control block; later ones have no place in the family.
    pub nodes: usize,
}

/// A state that can be written later, by another thread.
pub(super) trait OwnedState: Send + 'static {
    /// The state as the writer takes it.
    fn view(&self) -> StateView<'_>;
}

impl Family {
    /// A family named by `names`, with the start date in its title. `legacy`
    /// writes the control block exactly as the original did.
    pub fn new(
        names: &OutputNames,
        background: &Background,
        start: StartDate,
        legacy: bool,
    ) -> Self {
        let (names, background) = (names.clone(), background.clone());
        Self { names, background, start, legacy, open: None }
    }

    /// Whether the first state has been written.
    pub fn is_open(&self) -> bool {
        self.open.is_some()
    }

    /// Begins the files. `total` are the nodes and elements of the scene, which decide how many
    /// states a file takes.
    pub fn open(
        &mut self,
        control: ControlBlock,
        geometry: &Geometry,
        elements: &[usize],
        total: [usize; 2],
    ) -> Result<(), OutputError> {
        let control = if self.legacy { control.legacy() } else { control };
        let [nodes, all_elements] = total;
        let per_file = states_per_file(nodes, all_elements);
        let writer = FamilyWriter::create(&self.names.d3plot(), control, geometry, per_file)?;
        let elements = elements.iter().map(|&e| e as u32).collect();
        self.open = Some(OpenFamily::new(writer, per_file, elements, nodes));
        Ok(())
    }

    /// Hands over the state that `make` takes from what is shown.
    pub fn write<S: OwnedState>(
        &self,
        make: impl FnOnce(&OpenFamily) -> S,
    ) -> Result<(), OutputError> {
        let Some(family) = &self.open else { return Ok(()) };
        let (state, writer) = (make(family), Arc::clone(&family.writer));
        self.background.submit(move || Ok(lock(&writer).write_state(&state.view())?))
    }

    /// What a later run needs to go on with the family.
    pub fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let StartDate { day, month, year } = self.start;
        let family = self.open.as_mut().map(Continuation::of).transpose()?;
        encode(KIND, &FamilyNote { start: (day, month, year), family })
    }

    /// Goes on with a family of an earlier run, of a scene with `total` nodes and elements.
    pub fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        total: [usize; 2],
    ) -> Result<(), OutputError> {
        let mark: FamilyNote = decode(KIND, mark)?;
        let (day, month, year) = mark.start;
        if day > 31 || month > 12 || year > 9999 {
            return Err(OutputError::Mark { kind: KIND });
        }
        self.start = StartDate { day, month, year };
        self.open = mark.family.map(|family| family.open(names, total)).transpose()?;
        Ok(())
    }

    /// Completes the files.
    pub fn finish(self) -> Result<Vec<PathBuf>, OutputError> {
        let Some(family) = self.open else { return Ok(Vec::new()) };
        // all states are written, so that nobody else has the writer
        let still_used = || io::Error::other("it is still being written");
        let writer = Arc::into_inner(family.writer).ok_or_else(still_used);
        let writer = writer.map_err(OutputError::io(self.names.d3plot()))?;
        let writer = writer.into_inner().unwrap_or_else(PoisonError::into_inner);
        Ok(writer.finish()?.files)
    }
}

impl OpenFamily {
    fn new(writer: FamilyWriter, per_file: u64, elements: Vec<u32>, nodes: usize) -> Self {
        Self { writer: Arc::new(Mutex::new(writer)), per_file, elements, nodes }
    }

    /// The elements shown.
    pub fn elements(&self) -> impl Iterator<Item = usize> {
        self.elements.iter().map(|&e| e as usize)
    }
}

/// What a later run needs to go on with a family.
#[derive(Serialize, Deserialize)]
struct FamilyNote {
    /// Day, month and year of the title.
    start: (u8, u8, u16),
    family: Option<Continuation>,
}

#[derive(Serialize, Deserialize)]
struct Continuation {
    control: Vec<u8>,
    member: u32,
    states_in_file: u64,
    position: FilePosition,
    per_file: u64,
    elements: Vec<u32>,
    nodes: u32,
}

impl Continuation {
    fn of(family: &mut OpenFamily) -> Result<Self, OutputError> {
        let mark = lock(&family.writer).mark()?;
        Ok(Self {
            control: mark.control.to_bytes().to_vec(),
            member: mark.member,
            states_in_file: mark.states_in_file,
            position: mark.file.into(),
            per_file: family.per_file,
            elements: family.elements.clone(),
            nodes: family.nodes as u32,
        })
    }

    /// The family, if the mark is one of the scene.
    fn open(&self, names: &OutputNames, total: [usize; 2]) -> Result<OpenFamily, OutputError> {
        let unusable = OutputError::Mark { kind: KIND };
        let Ok(control) = <&[u8; ControlBlock::BYTES]>::try_from(self.control.as_slice()) else {
            return Err(unusable);
        };
        let nodes = self.nodes as usize;
        if self.elements.iter().any(|&e| e as usize >= total[1])
            || nodes > total[0]
            || self.states_in_file > self.per_file.max(1)
        {
            return Err(unusable);
        }
        let mark = FamilyMark {
            control: ControlBlock::from_bytes(control),
            member: self.member,
            states_in_file: self.states_in_file,
            file: self.position.into(),
        };
        let writer = FamilyWriter::resume(&names.d3plot(), self.per_file, &mark);
        let writer = writer.map_err(|error| match error {
            WriteError::Io { path, source } => OutputError::Changed { path, source },
            other => other.into(),
        })?;
        Ok(OpenFamily::new(writer, self.per_file, self.elements.clone(), nodes))
    }
}
