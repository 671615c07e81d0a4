//! `.pvd` collections: which file shows what at which time.

use std::io::{self, Write};
use std::path::Path;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};

use crate::error::{ConvertError, at};
use crate::replace_file::replace_file;

/// A time series of files, each a part of the picture at one time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PvdSeries {
    entries: Vec<Entry>,
}

#[derive(Debug, Clone, PartialEq)]
struct Entry {
    time: f64,
    part: u32,
    name: String,
    file: String,
}

impl PvdSeries {
    /// An empty series.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file: what it shows at `time` under the part number and name given. `file` is
    /// relative to the folder of the collection, with `/` between folders.
    pub fn push(&mut self, time: f64, part: u32, name: impl Into<String>, file: impl Into<String>) {
        self.entries.push(Entry { time, part, name: name.into(), file: file.into() });
    }

    /// How many files there are.
    pub fn len(&self) -> usize {
        self.entries.len()
    }

    /// Whether there are no files.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Writes the collection; what had the name before is replaced in one go, so that it can
    /// be written again and again while a run goes on.
    pub fn write(&self, path: &Path) -> Result<(), ConvertError> {
        replace_file(path, |output| self.encode(output)).map_err(at(path))
    }

    /// Writes the collection into `output`.
    pub fn encode(&self, output: impl Write) -> io::Result<()> {
        let mut xml = Writer::new_with_indent(output, b' ', 2);
        xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
        xml.write_event(Event::Start(BytesStart::new("VTKFile").with_attributes([
            ("type", "Collection"),
            ("version", "1.0"),
            ("byte_order", "LittleEndian"),
            ("header_type", "UInt64"),
        ])))?;
        xml.write_event(Event::Start(BytesStart::new("Collection")))?;
        for entry in &self.entries {
            let element = BytesStart::new("DataSet").with_attributes([
                ("timestep", format!("{:?}", entry.time).as_str()),
                ("group", ""),
                ("part", entry.part.to_string().as_str()),
                ("name", entry.name.as_str()),
                ("file", entry.file.as_str()),
            ]);
            xml.write_event(Event::Empty(element))?;
        }
        xml.write_event(Event::End(BytesEnd::new("Collection")))?;
        xml.write_event(Event::End(BytesEnd::new("VTKFile")))?;
        xml.get_mut().write_all(b"\n")
    }
}
