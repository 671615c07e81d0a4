//! A decoder of the `.vtu` files of the older converters: VTK 5.8, appended base64, zlib.

use std::collections::BTreeMap;
use std::io::Read;

use quick_xml::Reader;
use quick_xml::events::Event;

/// All arrays by name, widened to double.
pub fn decode(text: &str) -> BTreeMap<String, Vec<f64>> {
    let (header, rest) = text.split_once("<AppendedData").expect("appended data");
    let (_, blob) = rest.split_once('_').unwrap();
    let (blob, _) = blob.split_once("</AppendedData>").unwrap();
    let blob = blob.trim().as_bytes();
    let mut arrays = BTreeMap::new();
    let mut xml = Reader::from_str(header);
    while let Ok(event) = xml.read_event() {
        let element = match event {
            Event::Empty(element) if element.name().as_ref() == "DataArray" => element,
            Event::Eof => break,
            _ => continue,
        };
        let attributes: BTreeMap<String, String> = element
            .attributes()
            .map(|attribute| {
                let attribute = attribute.unwrap();
                (attribute.key.as_ref().to_owned(), attribute.value.trim().to_owned())
            })
            .collect();
        let data = block(&blob[attributes["offset"].parse().unwrap()..]);
        let values = match attributes["type"].as_str() {
            "Float64" => numbers(&data, f64::from_le_bytes),
            "Float32" => numbers(&data, |b| f64::from(f32::from_le_bytes(b))),
            "Int64" => numbers(&data, |b| i64::from_le_bytes(b) as f64),
            "UInt8" => numbers(&data, |[b]| f64::from(b)),
            other => panic!("type {other}"),
        };
        arrays.insert(attributes["Name"].clone(), values);
    }
    arrays
}

/// One array: a header of the numbers of blocks, their length, the length of the last one and the
/// compressed lengths, coded by itself, and then the compressed blocks.
fn block(text: &[u8]) -> Vec<u8> {
    let word = |bytes: &[u8], index: usize| {
        u32::from_le_bytes(bytes[4 * index..4 * index + 4].try_into().unwrap()) as usize
    };
    let blocks = word(&base64(text, 4), 0);
    let header = base64(text, 4 * (3 + blocks));
    let lengths: Vec<usize> = (0..blocks).map(|index| word(&header, 3 + index)).collect();
    let start = header.len().div_ceil(3) * 4;
    let packed = base64(&text[start..], lengths.iter().sum());
    let mut data = Vec::new();
    let mut at = 0;
    for length in lengths {
        let mut decoder = flate2::read::ZlibDecoder::new(&packed[at..at + length]);
        decoder.read_to_end(&mut data).unwrap();
        at += length;
    }
    data
}

/// The first `length` bytes.
fn base64(text: &[u8], length: usize) -> Vec<u8> {
    let digit = |byte: u8| match byte {
        b'A'..=b'Z' => byte - b'A',
        b'a'..=b'z' => byte - b'a' + 26,
        b'0'..=b'9' => byte - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        b'=' => 0,
        other => panic!("{other} is not base64"),
    };
    let mut bytes = Vec::new();
    for four in text[..length.div_ceil(3) * 4].chunks_exact(4) {
        let bits = four.iter().fold(0_u32, |bits, &byte| bits << 6 | u32::from(digit(byte)));
        bytes.extend_from_slice(&bits.to_be_bytes()[1..]);
    }
    bytes.truncate(length);
    bytes
}

fn numbers<const N: usize>(data: &[u8], number: impl Fn([u8; N]) -> f64) -> Vec<f64> {
    data.chunks_exact(N).map(|chunk| number(chunk.try_into().unwrap())).collect()
}
