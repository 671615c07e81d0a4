//! Colours and colour maps.

/// Red, green, blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Colour(pub [u8; 3]);

impl Colour {
    /// Lines and text.
    pub const INK: Self = Self([0x22, 0x22, 0x22]);
    /// Lesser text.
    pub const GREY: Self = Self([0x66, 0x66, 0x66]);
    /// Paper.
    pub const WHITE: Self = Self([0xff, 0xff, 0xff]);

    /// As in `#1f77b4`.
    #[must_use]
    pub fn hex(self) -> String {
        let [r, g, b] = self.0;
        format!("#{r:02x}{g:02x}{b:02x}")
    }
}

/// Colours for curves: the Okabe-Ito palette, told apart with any colour vision.
pub(super) const CURVES: [Colour; 7] = [
    Colour([0x00, 0x72, 0xb2]),
    Colour([0xd5, 0x5e, 0x00]),
    Colour([0x00, 0x9e, 0x73]),
    Colour([0xcc, 0x79, 0xa7]),
    Colour([0x56, 0xb4, 0xe9]),
    Colour([0xe6, 0x9f, 0x00]),
    Colour([0x00, 0x00, 0x00]),
];

/// From numbers to colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColourMap {
    /// Dark blue over green to yellow, evenly perceived: for fields without sign.
    Viridis,
    /// Blue over light grey to red: for fields with sign, grey is zero.
    CoolWarm,
}

impl ColourMap {
    /// The colour at `share` of the map, 0 to 1; what is outside gets the colour of the end,
    /// what is no number a light grey.
    #[must_use]
    pub fn colour(self, share: f64) -> Colour {
        if share.is_nan() {
            return Colour([0xcc, 0xcc, 0xcc]);
        }
        let knots = match self {
            Self::Viridis => &VIRIDIS,
            Self::CoolWarm => &COOL_WARM,
        };
        let at = share.clamp(0.0, 1.0) * (knots.len() - 1) as f64;
        let below = (at.floor() as usize).min(knots.len() - 2);
        let (low, high) = (knots[below], knots[below + 1]);
        let part = at - below as f64;
        let mix = |k: usize| f64::from(low[k]) + part * (f64::from(high[k]) - f64::from(low[k]));
        Colour([0, 1, 2].map(|k| mix(k).round() as u8))
    }
}

/// Viridis by Nathaniel Smith and Stéfan van der Walt (CC0), every eighth colour.
#[rustfmt::skip]
const VIRIDIS: [[u8; 3]; 33] = [
    [68, 1, 84], [71, 13, 96], [72, 24, 106], [72, 35, 116], [71, 45, 123], [69, 55, 129],
    [66, 64, 134], [62, 73, 137], [59, 82, 139], [55, 91, 141], [51, 99, 141], [47, 107, 142],
    [44, 114, 142], [41, 122, 142], [38, 130, 142], [35, 137, 142], [33, 145, 140],
    [31, 152, 139], [31, 160, 136], [34, 167, 133], [40, 174, 128], [50, 182, 122],
    [63, 188, 115], [78, 195, 107], [94, 201, 98], [112, 207, 87], [132, 212, 75],
    [152, 216, 62], [173, 220, 48], [194, 223, 35], [216, 226, 25], [236, 229, 27],
    [253, 231, 37],
];

/// Cool to warm after Kenneth Moreland (2009), 33 colours.
#[rustfmt::skip]
const COOL_WARM: [[u8; 3]; 33] = [
    [59, 76, 192], [68, 90, 204], [78, 104, 216], [88, 117, 225], [98, 130, 234],
    [108, 143, 241], [119, 154, 247], [130, 166, 251], [141, 176, 254], [152, 185, 255],
    [163, 194, 254], [174, 201, 252], [185, 208, 249], [195, 213, 244], [204, 217, 237],
    [213, 219, 229], [221, 220, 220], [229, 216, 209], [236, 211, 197], [241, 204, 184],
    [245, 196, 172], [247, 186, 159], [247, 176, 147], [246, 165, 134], [244, 152, 122],
    [240, 139, 110], [235, 125, 98], [228, 110, 86], [221, 95, 75], [212, 78, 65],
    [202, 59, 55], [190, 36, 46], [180, 4, 38],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_have_their_ends_and_their_middle() {
        assert_eq!(ColourMap::Viridis.colour(-1.0), Colour([68, 1, 84]));
        assert_eq!(ColourMap::Viridis.colour(1.0), Colour([253, 231, 37]));
        assert_eq!(ColourMap::CoolWarm.colour(0.5), Colour([221, 220, 220]));
        assert_eq!(ColourMap::CoolWarm.colour(f64::NAN).hex(), "#cccccc");
    }
}
