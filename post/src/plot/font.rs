//! The built-in font: DejaVu Sans, the characters that pictures need.

use std::sync::LazyLock;

use ttf_parser::Face;

/// The font file; its licence lies beside it.
static FONT: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

/// The font, if it can be read: a test says that it can.
pub(super) static FACE: LazyLock<Option<Face<'static>>> =
    LazyLock::new(|| Face::parse(FONT, 0).ok());

/// Width of a line of text, pixels.
pub(super) fn width(text: &str, size: f64) -> f64 {
    let Some(face) = &*FACE else { return 0.6 * size * text.chars().count() as f64 };
    let units = f64::from(face.units_per_em());
    let advance = |letter: char| {
        let glyph = face.glyph_index(letter).unwrap_or_default();
        f64::from(face.glyph_hor_advance(glyph).unwrap_or(0))
    };
    text.chars().map(advance).sum::<f64>() / units * size
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_font_has_what_pictures_say() {
        let face = FACE.as_ref().expect("the built-in font");
        for letter in "Stress σyy (MPa) × 10⁻³ − 0.5 ≤ µm · Ø äöüß é → … –".chars()
        {
            assert!(face.glyph_index(letter).is_some(), "{letter}");
        }
        assert!((width("00", 10.0) - 12.72).abs() < 0.01, "{}", width("00", 10.0));
    }
}
