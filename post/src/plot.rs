//! Pictures: contours of fields on the bodies, and curves.
//!
//! A [`Picture`] is a list of shapes in pixels; [`Picture::to_png`] and [`Picture::to_svg`] turn
//! it into a file. PNG text is drawn with a built-in font; SVG text is text.

mod axes;
mod bands;
mod colouring;
mod colours;
mod contour;
mod curves;
mod fills;
mod font;
mod joint_lines;
mod outline;
mod picture;
mod png;
mod scale;
mod solid;
mod svg;
mod weld;

pub use colours::{Colour, ColourMap};
pub use contour::{ContourOptions, JointLines, Range, contour};
pub use curves::{Curve, CurveOptions, Scale, curves, curves_on};
pub use picture::{Anchor, Picture, Shape};
pub use scale::{Ticks, prefix};
pub use solid::{Solid, SolidOptions, solid};
