//! A picture as a list of shapes.

use std::path::Path;

use std::io::Write;
use yformat::part_file::PartFile;

use super::colours::Colour;
use super::{png, svg};
use crate::error::{PostError, at};

/// Where a text hangs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// It begins at the point.
    Start,
    /// Its middle is at the point.
    Middle,
    /// It ends at the point.
    End,
}

/// Something drawn. Coordinates are pixels, x to the right and y down.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// Filled polygons of one colour. A seam is a line of the same colour around each, so that
    /// neighbours leave no gap.
    Polygons {
        /// Corners of each.
        rings: Vec<Vec<[f64; 2]>>,
        /// Colour.
        colour: Colour,
        /// Width of the seam; 0 for none.
        seam: f64,
    },
    /// Lines of one colour.
    Lines {
        /// Points of each.
        lines: Vec<Vec<[f64; 2]>>,
        /// Colour.
        colour: Colour,
        /// Width.
        width: f64,
        /// Lengths of dash and gap; `None` for unbroken lines.
        dash: Option<[f64; 2]>,
    },
    /// A line of text.
    Text {
        /// Left, middle or right end of its baseline.
        at: [f64; 2],
        /// What it says.
        text: String,
        /// Height of the font.
        size: f64,
        /// Where it hangs.
        anchor: Anchor,
        /// Whether it runs upwards.
        turned: bool,
        /// Colour.
        colour: Colour,
    },
    /// Shapes of which only what lies in a rectangle is seen.
    Clipped {
        /// Upper left and lower right corner.
        window: [[f64; 2]; 2],
        /// The shapes.
        shapes: Vec<Shape>,
    },
}

/// A picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Width, pixels.
    pub width: u32,
    /// Height, pixels.
    pub height: u32,
    /// What is drawn, the first undermost.
    pub shapes: Vec<Shape>,
}

impl Picture {
    /// The picture as an SVG file.
    #[must_use]
    pub fn to_svg(&self) -> String {
        svg::encode(self)
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// If the picture is empty or too large for memory.
    pub fn to_png(&self) -> Result<Vec<u8>, PostError> {
        png::encode(self)
    }

    /// Writes the picture as PNG or SVG, by the ending of `path`; the file takes its name when
    /// it is complete.
    ///
    /// # Errors
    /// If the ending is neither, or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), PostError> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        let bytes = match ending.to_ascii_lowercase().as_str() {
            "png" => self.to_png()?,
            "svg" => self.to_svg().into_bytes(),
            _ => {
                let found = path.display().to_string();
                return Err(PostError::words("the picture", found, "expected .png or .svg"));
            }
        };
        let write = || {
            let mut file = PartFile::create(path)?;
            file.write_all(&bytes)?;
            file.complete()
        };
        write().map(drop).map_err(at(path))
    }
}
