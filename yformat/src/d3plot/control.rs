//! The control block: the 64 words at the head of the first file.

use super::error::WriteError;
use super::title::Title;

/// A value that fills one 4-byte word.
trait Word: Copy {
    fn from_bits(bits: u32) -> Self;
    fn bits(self) -> u32;
}

impl Word for i32 {
    fn from_bits(bits: u32) -> Self {
        bits.cast_signed()
    }
    fn bits(self) -> u32 {
        self.cast_unsigned()
    }
}

impl Word for f32 {
    fn from_bits(bits: u32) -> Self {
        f32::from_bits(bits)
    }
    fn bits(self) -> u32 {
        self.to_bits()
    }
}

/// Writes the struct and its two conversions from one list of words, in file order.
macro_rules! control_block {
    ($($(#[$doc:meta])* $name:ident: $kind:ty,)*) => {
        /// The 64 words at the head of the first file, under the names of the LS-DYNA database
        /// manual. What the words mean to Y is told at each field.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct ControlBlock {
            /// Words 0 to 9: the title.
            pub title: Title,
            $($(#[$doc])* pub $name: $kind,)*
        }

        impl ControlBlock {
            /// Reads the block from its bytes; every bit pattern is accepted here.
            pub fn from_bytes(bytes: &[u8; Self::BYTES]) -> Self {
                let mut title = [0; 40];
                title.copy_from_slice(&bytes[..40]);
                let mut words = bytes[40..]
                    .chunks_exact(4)
                    .map(|w| u32::from_le_bytes([w[0], w[1], w[2], w[3]]));
                Self {
                    title: Title::from_bytes(title),
                    $($name: <$kind as Word>::from_bits(words.next().unwrap_or(0)),)*
                }
            }

            /// The bytes of the block.
            pub fn to_bytes(&self) -> [u8; Self::BYTES] {
                let mut bytes = [0; Self::BYTES];
                bytes[..40].copy_from_slice(self.title.as_bytes());
                let words = [$(Word::bits(self.$name),)*];
                for (slot, word) in bytes[40..].chunks_exact_mut(4).zip(words) {
                    slot.copy_from_slice(&word.to_le_bytes());
                }
                bytes
            }
        }
    };
}

control_block! {
    /// Word 10: run time; Y leaves 0.
    run_time: i32,
    /// Word 11: file type; 1 is a d3plot, Y left 0.
    file_type: i32,
    /// Word 12: source version.
    source_version: i32,
    /// Word 13: release number.
    release_number: i32,
    /// Word 14: version of the code.
    version: f32,
    /// Word 15: number of dimensions; 4 means three, with unpacked connectivity.
    ndim: i32,
    /// Word 16: number of nodes.
    numnp: i32,
    /// Word 17: code flag; 6 is LS-DYNA's own layout.
    icode: i32,
    /// Word 18: number of global values per state; Y fills the first with the kinetic energy.
    nglbv: i32,
    /// Word 19: temperatures per node.
    it: i32,
    /// Word 20: 1 when states hold current coordinates.
    iu: i32,
    /// Word 21: 1 when states hold velocities.
    iv: i32,
    /// Word 22: 1 when states hold accelerations; Y puts joint forces there (zero in 2D).
    ia: i32,
    /// Word 23: number of 8-node solids; Y counts its tetrahedra and 3D joints here.
    nel8: i32,
    /// Word 24: number of materials of the solids.
    nummat8: i32,
    /// Word 25: obsolete.
    numds: i32,
    /// Word 26: obsolete.
    numst: i32,
    /// Word 27: values per solid in a state.
    nv3d: i32,
    /// Word 28: number of beams.
    nel2: i32,
    /// Word 29: number of materials of the beams.
    nummat2: i32,
    /// Word 30: values per beam in a state.
    nv1d: i32,
    /// Word 31: number of 4-node shells; Y counts its triangles and 2D joints here.
    nel4: i32,
    /// Word 32: number of materials of the shells.
    nummat4: i32,
    /// Word 33: values per shell in a state.
    nv2d: i32,
    /// Word 34: extra values per solid.
    neiph: i32,
    /// Word 35: extra values per shell.
    neips: i32,
    /// Word 36: integration points through the shell; below -10000 states end with an
    /// element-deletion table, between -10000 and -1 with a node-deletion table.
    maxint: i32,
    /// Word 37: number of smooth-particle nodes.
    nmsph: i32,
    /// Word 38: number of smooth-particle materials.
    ngpsph: i32,
    /// Word 39: words of the arbitrary-numbering tables.
    narbs: i32,
    /// Word 40: number of thick shells.
    nelt: i32,
    /// Word 41: number of materials of the thick shells.
    nummatt: i32,
    /// Word 42: values per thick shell in a state.
    nv3dt: i32,
    /// Word 43: 1000 when stresses are there, of shells and of solids. Y left 1 in 2D and 0 in
    /// 3D, which readers that go by the manual take for "no stresses".
    ioshl1: i32,
    /// Word 44: 1000 when effective plastic strains are there; said in 3D, where the seventh
    /// value of a solid stands in its place.
    ioshl2: i32,
    /// Word 45: shell force resultants are there.
    ioshl3: i32,
    /// Word 46: shell thickness and energies are there.
    ioshl4: i32,
    /// Word 47: number of ALE materials.
    ialemat: i32,
    /// Word 48: first flag word of the CFD data.
    ncfdv1: i32,
    /// Word 49: second flag word of the CFD data.
    ncfdv2: i32,
    /// Word 50: number of adapted elements.
    nadapt: i32,
    /// Word 51: total number of materials.
    nmmat: i32,
    /// Word 52: number of fluid materials.
    numfluid: i32,
    /// Word 53: invariant numbering of the shell stresses.
    inn: i32,
    /// Word 54: number of airbag particles values.
    npefg: i32,
    /// Word 55: number of 8-node shells.
    nel48: i32,
    /// Word 56: flags of further nodal and element data.
    idtdt: i32,
    /// Word 57: words of a header extension.
    extra: i32,
    /// Word 58: spare.
    spare_58: i32,
    /// Word 59: spare.
    spare_59: i32,
    /// Word 60: spare.
    spare_60: i32,
    /// Word 61: spare.
    spare_61: i32,
    /// Word 62: spare.
    spare_62: i32,
    /// Word 63: spare.
    spare_63: i32,
}

/// The flag by which LS-DYNA says that data are there.
const DATA_PRESENT: i32 = 1000;

/// How much a scene holds, for the control block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Counts {
    /// Nodes.
    pub nodes: usize,
    /// Elements written to the file: continuum elements and joints.
    pub elements: usize,
    /// Element property sets of the deck (`NPROP`).
    pub properties: usize,
}

impl ControlBlock {
    /// Words of the block.
    pub const WORDS: usize = 64;
    /// Bytes of the block.
    pub const BYTES: usize = 4 * Self::WORDS;

    /// The block of a 2D run: every element is a shell.
    pub fn two_dimensional(title: Title, counts: Counts) -> Result<Self, WriteError> {
        let properties = word("properties", counts.properties)?;
        Ok(Self {
            nel4: word("elements", counts.elements)?,
            nummat4: properties,
            ioshl1: DATA_PRESENT,
            ..Self::common(title, counts)?
        })
    }

    /// The block of a 3D run: every element is a solid.
    pub fn three_dimensional(title: Title, counts: Counts) -> Result<Self, WriteError> {
        let properties = word("properties", counts.properties)?;
        Ok(Self {
            nel8: word("elements", counts.elements)?,
            nummat8: properties,
            ioshl1: DATA_PRESENT,
            ioshl2: DATA_PRESENT,
            ..Self::common(title, counts)?
        })
    }

    /// The same block with the words Y wrote where they differ: file type 0, word 43 1 in 2D
    /// and 0 in 3D, word 44 0. LS-PrePost does not mind; other readers refuse the file or miss
    /// the stresses.
    pub fn legacy(self) -> Self {
        Self { file_type: 0, ioshl1: i32::from(self.nel4 > 0), ioshl2: 0, ..self }
    }

    fn common(title: Title, counts: Counts) -> Result<Self, WriteError> {
        let properties = word("properties", counts.properties)?;
        let globals = 7 * counts.properties as u64 + 6;
        let spare = [0; Self::BYTES];
        Ok(Self {
            title,
            file_type: 1,
            source_version: 971,
            release_number: 50_638_000,
            version: 960.0,
            ndim: 4,
            numnp: word("nodes", counts.nodes)?,
            icode: 6,
            nglbv: i32::try_from(globals)
                .map_err(|_| WriteError::TooMany { what: "global values", count: globals })?,
            iu: 1,
            iv: 1,
            ia: 1,
            nv3d: 7,
            nv1d: 6,
            nv2d: 6,
            maxint: -10_001,
            nmmat: properties,
            ..Self::from_bytes(&spare)
        })
    }
}

fn word(what: &'static str, count: usize) -> Result<i32, WriteError> {
    i32::try_from(count).map_err(|_| WriteError::TooMany { what, count: count as u64 })
}
