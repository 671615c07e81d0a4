//! Pictures as SVG.

use std::fmt::Write;

use super::picture::{Anchor, Picture, Shape};

/// The fonts asked for: the built-in one of the PNG files where it is installed.
const FONTS: &str = "DejaVu Sans, Verdana, Helvetica, Arial, sans-serif";

/// The file.
pub(super) fn encode(picture: &Picture) -> String {
    let (width, height) = (picture.width, picture.height);
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" font-family=\"{FONTS}\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>\n"
    );
    let mut windows = 0;
    draw(&mut text, &picture.shapes, &mut windows);
    text.push_str("</svg>\n");
    text
}

fn draw(text: &mut String, shapes: &[Shape], windows: &mut usize) {
    for shape in shapes {
        match shape {
            Shape::Polygons { rings, colour, seam } => {
                let colour = colour.hex();
                text.push_str("<path d=\"");
                rings.iter().for_each(|ring| path(text, ring, true));
                let _ = write!(text, "\" fill=\"{colour}\"");
                if *seam > 0.0 {
                    let width = number(*seam);
                    let _ = write!(text, " stroke=\"{colour}\" stroke-width=\"{width}\"");
                    text.push_str(" stroke-linejoin=\"bevel\"");
                }
                text.push_str("/>\n");
            }
            Shape::Lines { lines, colour, width, dash } => {
                text.push_str("<path d=\"");
                lines.iter().for_each(|line| path(text, line, false));
                let (colour, width) = (colour.hex(), number(*width));
                let _ = write!(
                    text,
                    "\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{width}\" \
                     stroke-linejoin=\"round\""
                );
                match dash {
                    Some([on, off]) => {
                        let (on, off) = (number(*on), number(*off));
                        let _ = write!(text, " stroke-dasharray=\"{on} {off}\"");
                    }
                    None => text.push_str(" stroke-linecap=\"round\""),
                }
                text.push_str("/>\n");
            }
            Shape::Text { at, text: words, size, anchor, turned, colour } => {
                let (x, y, size) = (number(at[0]), number(at[1]), number(*size));
                let anchor = match anchor {
                    Anchor::Start => "start",
                    Anchor::Middle => "middle",
                    Anchor::End => "end",
                };
                let _ = write!(
                    text,
                    "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" text-anchor=\"{anchor}\" \
                     fill=\"{}\"",
                    colour.hex()
                );
                if *turned {
                    let _ = write!(text, " transform=\"rotate(-90 {x} {y})\"");
                }
                let _ = writeln!(text, ">{}</text>", escaped(words));
            }
            Shape::Clipped { window: [a, b], shapes } => {
                *windows += 1;
                let (x, y) = (number(a[0]), number(a[1]));
                let (width, height) = (number(b[0] - a[0]), number(b[1] - a[1]));
                let _ = writeln!(
                    text,
                    "<clipPath id=\"window{windows}\"><rect x=\"{x}\" y=\"{y}\" width=\"{width}\" \
                     height=\"{height}\"/></clipPath>\n<g clip-path=\"url(#window{windows})\">"
                );
                draw(text, shapes, windows);
                text.push_str("</g>\n");
            }
        }
    }
}

fn path(text: &mut String, points: &[[f64; 2]], closed: bool) {
    let mut command = 'M';
    for point in points.iter().filter(|p| p.iter().all(|x| x.abs() < 1e6)) {
        let _ = write!(text, "{command}{} {}", number(point[0]), number(point[1]));
        command = 'L';
    }
    if closed && command == 'L' {
        text.push('Z');
    }
}

/// A hundredth of a pixel is enough.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
