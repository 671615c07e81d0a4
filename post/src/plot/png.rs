//! Pictures as PNG.

use tiny_skia::{
    FillRule, LineCap, LineJoin, Mask, Paint, Path, PathBuilder, Pixmap, Rect, Stroke, StrokeDash,
    Transform,
};
use ttf_parser::OutlineBuilder;

use super::colours::Colour;
use super::font::{FACE, width};
use super::picture::{Anchor, Picture, Shape};
use crate::error::PostError;

/// Draws the picture and encodes it.
pub(super) fn encode(picture: &Picture) -> Result<Vec<u8>, PostError> {
    let size = format!("{} x {}", picture.width, picture.height);
    let mut pixmap = Pixmap::new(picture.width, picture.height).ok_or_else(|| {
        PostError::words("the size of the picture", &size, "expected at least 1 x 1 pixels")
    })?;
    pixmap.fill(tiny_skia::Color::WHITE);
    draw(&mut pixmap, &picture.shapes, None);
    pixmap
        .encode_png()
        .map_err(|error| PostError::words("the size of the picture", size, error.to_string()))
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    let [r, g, b] = colour.0;
    paint.set_color_rgba8(r, g, b, 255);
    paint
}

fn draw(pixmap: &mut Pixmap, shapes: &[Shape], mask: Option<&Mask>) {
    let identity = Transform::identity();
    for shape in shapes {
        match shape {
            Shape::Polygons { rings, colour, seam } => {
                // one by one: overlapping polygons of one path would cancel out
                for ring in rings {
                    let Some(path) = line_path(std::slice::from_ref(ring), true) else { continue };
                    pixmap.fill_path(&path, &paint(*colour), FillRule::Winding, identity, mask);
                    if *seam > 0.0 {
                        let stroke = Stroke {
                            width: *seam as f32,
                            line_join: LineJoin::Bevel,
                            ..Stroke::default()
                        };
                        pixmap.stroke_path(&path, &paint(*colour), &stroke, identity, mask);
                    }
                }
            }
            Shape::Lines { lines, colour, width, dash } => {
                let Some(path) = line_path(lines, false) else { continue };
                let dash =
                    dash.and_then(|[on, off]| StrokeDash::new(vec![on as f32, off as f32], 0.0));
                let line_cap = if dash.is_some() { LineCap::Butt } else { LineCap::Round };
                let stroke = Stroke {
                    width: *width as f32,
                    line_cap,
                    line_join: LineJoin::Round,
                    dash,
                    ..Stroke::default()
                };
                pixmap.stroke_path(&path, &paint(*colour), &stroke, identity, mask);
            }
            Shape::Text { at, text, size, anchor, turned, colour } => {
                if let Some(path) = text_path(text, *size, *anchor) {
                    let (x, y) = (at[0] as f32, at[1] as f32);
                    let place = if *turned {
                        Transform::from_row(0.0, -1.0, 1.0, 0.0, x, y)
                    } else {
                        Transform::from_translate(x, y)
                    };
                    pixmap.fill_path(&path, &paint(*colour), FillRule::Winding, place, mask);
                }
            }
            Shape::Clipped { window: [a, b], shapes } => {
                let rect = Rect::from_ltrb(a[0] as f32, a[1] as f32, b[0] as f32, b[1] as f32);
                let window = rect.zip(Mask::new(pixmap.width(), pixmap.height()));
                if let Some((rect, mut window)) = window {
                    let path = PathBuilder::from_rect(rect);
                    window.fill_path(&path, FillRule::Winding, true, identity);
                    draw(pixmap, shapes, Some(&window));
                }
            }
        }
    }
}

/// A path of lines, closed or open; points that are no numbers or far outside are left out.
fn line_path(lines: &[Vec<[f64; 2]>], closed: bool) -> Option<Path> {
    let mut builder = PathBuilder::new();
    for line in lines {
        let seen = |p: &&[f64; 2]| p.iter().all(|x| x.abs() < 1e6);
        let mut points = line.iter().filter(seen).map(|p| (p[0] as f32, p[1] as f32));
        let Some((x, y)) = points.next() else { continue };
        builder.move_to(x, y);
        points.for_each(|(x, y)| builder.line_to(x, y));
        if closed {
            builder.close();
        }
    }
    builder.finish()
}

/// Outlines of glyphs, y turned down, scaled and moved.
struct Outlines {
    builder: PathBuilder,
    scale: f32,
    x: f32,
}

impl OutlineBuilder for Outlines {
    fn move_to(&mut self, x: f32, y: f32) {
        self.builder.move_to(self.x + self.scale * x, -self.scale * y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.builder.line_to(self.x + self.scale * x, -self.scale * y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let (s, o) = (self.scale, self.x);
        self.builder.quad_to(o + s * x1, -s * y1, o + s * x, -s * y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let (s, o) = (self.scale, self.x);
        self.builder.cubic_to(o + s * x1, -s * y1, o + s * x2, -s * y2, o + s * x, -s * y);
    }
    fn close(&mut self) {
        self.builder.close();
    }
}

fn text_path(text: &str, size: f64, anchor: Anchor) -> Option<Path> {
    let face = FACE.as_ref()?;
    let length = width(text, size) as f32;
    let x = match anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -0.5 * length,
        Anchor::End => -length,
    };
    let scale = size as f32 / f32::from(face.units_per_em());
    let mut outlines = Outlines { builder: PathBuilder::new(), scale, x };
    for letter in text.chars() {
        let glyph = face.glyph_index(letter).unwrap_or_default();
        face.outline_glyph(glyph, &mut outlines);
        outlines.x += scale * f32::from(face.glyph_hor_advance(glyph).unwrap_or(0));
    }
    outlines.builder.finish()
}
