//! Where the parts of a family's records lie, computed from the control block.

use super::control::ControlBlock;
use super::error::ReadError;

/// What follows the element data of a state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum DeletionTable {
    None,
    Nodes,
    Elements,
}

/// Lengths of the parts of the geometry section and of one state, in words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StateLayout {
    /// Nodes.
    pub nodes: u64,
    /// 8-node solids.
    pub solids: u64,
    /// 4-node shells.
    pub shells: u64,
    /// Global values of a state.
    pub globals: u64,
    /// Whether a state holds coordinates, velocities and accelerations.
    pub vectors: [bool; 3],
    /// Words per solid in a state.
    pub words_per_solid: u64,
    /// Words per shell in a state.
    pub words_per_shell: u64,
    /// Words of the deletion table of a state.
    pub deletion_table: u64,
}

impl StateLayout {
    /// Checks the control block and works out the layout.
    ///
    /// Kinds of data that Y never writes (beams, thick shells, particles, temperatures, ...)
    /// are refused.
    pub fn new(control: &ControlBlock) -> Result<Self, ReadError> {
        check(control)?;
        let nodes = length(control.numnp);
        let solids = length(control.nel8);
        let shells = length(control.nel4);
        let table = match control.maxint {
            0.. => DeletionTable::None,
            -10_000..=-1 => DeletionTable::Nodes,
            _ => DeletionTable::Elements,
        };
        Ok(Self {
            nodes,
            solids,
            shells,
            globals: length(control.nglbv),
            vectors: [control.iu, control.iv, control.ia].map(|flag| flag != 0),
            words_per_solid: length(control.nv3d),
            words_per_shell: length(control.nv2d),
            deletion_table: match table {
                DeletionTable::None => 0,
                DeletionTable::Nodes => nodes,
                DeletionTable::Elements => solids + shells,
            },
        })
    }

    /// Words of the geometry section.
    pub fn geometry_words(&self) -> u64 {
        3 * self.nodes + 9 * self.solids + 5 * self.shells
    }

    /// Words of one state. No sum here can overflow: every factor is below 2³¹.
    pub fn state_words(&self) -> u64 {
        let vectors = self.vectors.iter().filter(|&&there| there).count() as u64;
        1 + self.globals
            + 3 * vectors * self.nodes
            + self.words_per_solid * self.solids
            + self.words_per_shell * self.shells
            + self.deletion_table
    }

    /// Bytes of one state; counts of a damaged file can make it saturate.
    pub fn state_bytes(&self) -> u64 {
        self.state_words().saturating_mul(4)
    }
}

/// A count that [`check`] has found to be positive or zero.
fn length(word: i32) -> u64 {
    u64::try_from(word).unwrap_or(0)
}

fn check(control: &ControlBlock) -> Result<(), ReadError> {
    let refuse = |word, name, value, reason| Err(ReadError::Control { word, name, value, reason });
    if !matches!(control.file_type, 0 | 1) {
        let reason = "1 (or 0 in files of Y) is expected";
        return refuse(11, "file type", control.file_type, reason);
    }
    if !matches!(control.ndim, 3 | 4) {
        let reason = "only 4 (three dimensions, unpacked) and 3 are read";
        return refuse(15, "NDIM", control.ndim, reason);
    }
    if control.numnp < 1 {
        return refuse(16, "NUMNP", control.numnp, "there must be nodes");
    }
    let counts = [
        (18, "NGLBV", control.nglbv),
        (23, "NEL8", control.nel8),
        (27, "NV3D", control.nv3d),
        (31, "NEL4", control.nel4),
        (33, "NV2D", control.nv2d),
    ];
    for (word, name, value) in counts {
        if value < 0 {
            return refuse(word, name, value, "must not be negative");
        }
    }
    let flags = [(20, "IU", control.iu), (21, "IV", control.iv), (22, "IA", control.ia)];
    for (word, name, value) in flags {
        if !matches!(value, 0 | 1) {
            return refuse(word, name, value, "0 or 1 is expected");
        }
    }
    let absent = [
        (19, "IT", control.it),
        (28, "NEL2", control.nel2),
        (37, "NMSPH", control.nmsph),
        (39, "NARBS", control.narbs),
        (40, "NELT", control.nelt),
        (47, "IALEMAT", control.ialemat),
        (48, "NCFDV1", control.ncfdv1),
        (49, "NCFDV2", control.ncfdv2),
        (50, "NADAPT", control.nadapt),
        (52, "NUMFLUID", control.numfluid),
        (54, "NPEFG", control.npefg),
        (55, "NEL48", control.nel48),
        (56, "IDTDT", control.idtdt),
        (57, "EXTRA", control.extra),
    ];
    for (word, name, value) in absent {
        if value != 0 {
            return refuse(word, name, value, "data of this kind are not read");
        }
    }
    Ok(())
}
