//! A small decoder of `.vtu` files with raw appended data, written against the VTK file format
//! description, to look at what the writer wrote from the other side.

use std::collections::BTreeMap;

use quick_xml::Reader;
use quick_xml::events::Event;

/// A decoded array: its attributes and its numbers, all widened to double.
#[derive(Debug, Clone, Default)]
pub struct Array {
    pub section: String,
    pub attributes: BTreeMap<String, String>,
    pub values: Vec<f64>,
}

/// A decoded file.
#[derive(Debug)]
pub struct Vtu {
    /// The XML up to the underscore.
    #[allow(dead_code, reason = "not every test looks at it")]
    pub header: String,
    /// Attributes of `VTKFile` and `Piece`.
    pub attributes: BTreeMap<String, String>,
    pub arrays: Vec<Array>,
}

impl Vtu {
    pub fn array(&self, section: &str, name: &str) -> &Array {
        self.arrays
            .iter()
            .find(|a| a.section == section && a.attributes["Name"] == name)
            .unwrap_or_else(|| panic!("no {name} in {section}"))
    }
}

pub fn decode(bytes: &[u8]) -> Vtu {
    let mark = b"<AppendedData encoding=\"raw\">";
    let at = find(bytes, mark).expect("appended data") + mark.len();
    let underscore = at + find(&bytes[at..], b"_").unwrap();
    let header = String::from_utf8(bytes[..=underscore].to_vec()).unwrap();
    let blocks = &bytes[underscore + 1..];

    let mut xml = Reader::from_str(&header);
    let mut path: Vec<String> = Vec::new();
    let mut attributes = BTreeMap::new();
    let mut arrays = Vec::new();
    let mut end = 0;
    loop {
        match xml.read_event().unwrap() {
            Event::Start(element) => {
                let name = element.name().as_ref().to_owned();
                if name == "VTKFile" || name == "Piece" {
                    attributes.extend(attributes_of(&element));
                }
                path.push(name);
            }
            Event::End(_) => {
                path.pop();
            }
            Event::Empty(element) => {
                let attributes = attributes_of(&element);
                assert_eq!(attributes["format"], "appended");
                let offset: usize = attributes["offset"].parse().unwrap();
                assert_eq!(offset, end, "blocks follow each other");
                let values = block(blocks, offset, &attributes["type"], &mut end);
                arrays.push(Array { section: path.last().unwrap().clone(), attributes, values });
            }
            Event::Eof => break,
            _ => {}
        }
    }
    let tail = String::from_utf8(blocks[end..].to_vec()).unwrap();
    assert_eq!(tail.split_whitespace().collect::<String>(), "</AppendedData></VTKFile>");
    Vtu { header, attributes, arrays }
}

fn block(blocks: &[u8], offset: usize, kind: &str, end: &mut usize) -> Vec<f64> {
    let length: [u8; 8] = blocks[offset..offset + 8].try_into().unwrap();
    let length = usize::try_from(u64::from_le_bytes(length)).unwrap();
    let data = &blocks[offset + 8..offset + 8 + length];
    *end = offset + 8 + length;
    match kind {
        "Float64" => numbers(data, f64::from_le_bytes),
        "Float32" => numbers(data, |b| f64::from(f32::from_le_bytes(b))),
        "Int64" => numbers(data, |b| i64::from_le_bytes(b) as f64),
        "Int32" => numbers(data, |b| f64::from(i32::from_le_bytes(b))),
        "UInt8" => numbers(data, |[b]| f64::from(b)),
        other => panic!("type {other}"),
    }
}

fn numbers<const N: usize>(data: &[u8], number: impl Fn([u8; N]) -> f64) -> Vec<f64> {
    assert_eq!(data.len() % N, 0);
    data.chunks_exact(N).map(|chunk| number(chunk.try_into().unwrap())).collect()
}

fn attributes_of(element: &quick_xml::events::BytesStart<'_>) -> BTreeMap<String, String> {
    element
        .attributes()
        .map(|attribute| {
            let attribute = attribute.unwrap();
            let key = attribute.key.as_ref().to_owned();
            let value = attribute.value.into_owned();
            (key, quick_xml::escape::unescape(&value).unwrap().into_owned())
        })
        .collect()
}

fn find(bytes: &[u8], pattern: &[u8]) -> Option<usize> {
    bytes.windows(pattern.len()).position(|window| window == pattern)
}
