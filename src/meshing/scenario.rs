//! Scenario files.

use super::{
    MeshingError,
    kinds::{
        Arch, BlockOnPlane, Bridge, Column, Cube, Dominoes, RockingBlock, TwoBars, TwoBlocks, Wall,
    },
    loads::{Load, Staging},
    model::Model,
    properties::{count, not_negative, positive},
    spatial::{
        SpatialModel,
        kinds::{BlockOnPlane3d, Bridge3d, Cube3d, TwoBars3d, TwoCubes3d, Wall3d},
    },
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A structure, its loads and its run, as a TOML file says it.
///
/// ```
/// use ypsilon::meshing::Scenario;
///
/// let scenario = Scenario::parse(
///     "[column]\nblocks = 3\n[[loads]]\ntype = \"point\"\nforce_n = 1e4\n",
/// )?;
/// let generated = scenario.generate()?;
/// assert_eq!(generated.model.mesh.blocks, 3);
/// # Ok::<(), ypsilon::meshing::MeshingError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Scenario {
    /// One line that says what it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<String>,
    /// The structure: an arch bridge of masonry.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bridge: Option<Bridge>,
    /// The structure: a wall in running bond between two beams.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall: Option<Wall>,
    /// The structure: a block that slides on a plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block_on_plane: Option<BlockOnPlane>,
    /// The structure: two blocks that collide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub two_blocks: Option<TwoBlocks>,
    /// The structure: two bars with a gap that a force closes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub two_bars: Option<TwoBars>,
    /// The structure: blocks on top of each other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub column: Option<Column>,
    /// The structure: a cube, in plane form a square.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cube: Option<Cube>,
    /// The structure: an arch of dry voussoirs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub arch: Option<Arch>,
    /// The structure: a block that rocks on a plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rocking_block: Option<RockingBlock>,
    /// The structure: dominoes that topple one after the other.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dominoes: Option<Dominoes>,
    /// The structure in space: a box that is deformed in a known way, pressed, or left to its weight.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cube_3d: Option<Cube3d>,
    /// The structure in space: a block that slides on a plane.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub block_on_plane_3d: Option<BlockOnPlane3d>,
    /// The structure in space: two cubes that collide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub two_cubes_3d: Option<TwoCubes3d>,
    /// The structure in space: two bars with a gap that a force closes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub two_bars_3d: Option<TwoBars3d>,
    /// The structure in space: a wall of bricks that is pushed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wall_3d: Option<Wall3d>,
    /// The structure in space: an arch bridge of masonry.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bridge_3d: Option<Bridge3d>,
    /// Times, contact and output of the run.
    pub run: RunTimes,
    /// When and how fast loads come.
    pub staging: Staging,
    /// What is put on the structure.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub loads: Vec<Load>,
    /// Sums over nodes that are written while the run goes on.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub monitors: Vec<Watch>,
}

/// Times, contact and output of a run.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RunTimes {
    /// Time step \[s\]; about three quarters of what is stable if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step_s: Option<f64>,
    /// End of the run \[s\]; when the loads have settled if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub end_s: Option<f64>,
    /// Time between outputs \[s\]; a fortieth of the run if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub output_s: Option<f64>,
    /// Distance up to which triangles are watched for contact \[m\]; a tenth of their mean height
    /// if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact_buffer_m: Option<f64>,
    /// Whether bodies can touch; they can if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contact: Option<bool>,
    /// Steps between two lines of the monitors; 100 if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub monitor_interval: Option<usize>,
}

/// Sums over the nodes of a selection, as `ypsilon run --monitor` writes them.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Watch {
    /// Name of the columns.
    pub name: String,
    /// The nodes: `all`, `set:N`, `box:X0:X1,Y0:Y1` and so on.
    pub nodes: String,
    /// What is summed up, such as `reaction-x` or `kinetic-energy`.
    pub quantities: Vec<String>,
}

/// A structure that a generator makes.
pub trait Kind {
    /// The structure's model: mesh, materials, supports.
    ///
    /// # Errors
    /// If a parameter has no sense.
    fn model(&self) -> Result<Model, MeshingError>;
}

/// A structure in space that a generator makes.
pub trait SpatialKind {
    /// The structure's model: mesh, materials, supports.
    ///
    /// # Errors
    /// If a parameter has no sense.
    fn model(&self) -> Result<SpatialModel, MeshingError>;
}

/// A structure in the plane or in space.
#[derive(Clone, Copy)]
pub enum AnyKind<'a> {
    /// Of triangles.
    Plane(&'a dyn Kind),
    /// Of tetrahedra.
    Spatial(&'a dyn SpatialKind),
}

macro_rules! kinds {
    (
        plane { $($field:ident: $kind:ty, $title:literal;)* }
        space { $($spatial_field:ident: $spatial:ty, $spatial_title:literal;)* }
    ) => {
        $(impl Kind for $kind {
            fn model(&self) -> Result<Model, MeshingError> {
                <$kind>::model(self)
            }
        })*

        $(impl SpatialKind for $spatial {
            fn model(&self) -> Result<SpatialModel, MeshingError> {
                <$spatial>::model(self)
            }
        })*

        impl Scenario {
            /// Kinds of structures: how scenario files call them, and what they are.
            pub const KINDS: &'static [(&'static str, &'static str)] =
                &[
                    $((stringify!($field), $title),)*
                    $((stringify!($spatial_field), $spatial_title),)*
                ];

            /// Structures that are described here; a scenario has one.
            fn kinds(&self) -> Vec<(&'static str, AnyKind<'_>)> {
                let mut found = Vec::new();
                $(if let Some(kind) = &self.$field {
                    found.push((stringify!($field), AnyKind::Plane(kind)));
                })*
                $(if let Some(kind) = &self.$spatial_field {
                    found.push((stringify!($spatial_field), AnyKind::Spatial(kind)));
                })*
                found
            }

            /// A scenario of a kind with the kind's defaults; none if there is no such kind.
            #[must_use]
            pub fn of_kind(name: &str) -> Option<Self> {
                match name {
                    $(stringify!($field) => Some(Scenario {
                        $field: Some(<$kind>::default()),
                        ..Scenario::default()
                    }),)*
                    $(stringify!($spatial_field) => Some(Scenario {
                        $spatial_field: Some(<$spatial>::default()),
                        ..Scenario::default()
                    }),)*
                    _ => None,
                }
            }
        }
    };
}

kinds! {
    plane {
        bridge: Bridge, "arch bridge of masonry with spandrels, footings and soil";
        wall: Wall, "wall of bricks in running bond between two beams, loaded and sheared";
        block_on_plane: BlockOnPlane, "block that slides on a plane";
        two_blocks: TwoBlocks, "two blocks in line that collide";
        two_bars: TwoBars, "two bars with a gap that a force closes";
        column: Column, "dry blocks on top of each other";
        cube: Cube, "square that is deformed in a known way, pressed, or left to its weight";
        arch: Arch, "circular arch of dry voussoirs between two held blocks";
        rocking_block: RockingBlock, "slender block that is tilted and let go on a plane";
        dominoes: Dominoes, "row of dominoes, the first one pushed";
    }
    space {
        cube_3d: Cube3d, "box in space that is deformed in a known way, pressed, or left to its weight";
        block_on_plane_3d: BlockOnPlane3d, "block that slides on a plane, in space";
        two_cubes_3d: TwoCubes3d, "two cubes in line that collide, in space";
        two_bars_3d: TwoBars3d, "two bars with a gap that a force closes, in space";
        wall_3d: Wall3d, "wall of bricks with leaves and headers, pushed at its top, in space";
        bridge_3d: Bridge3d, "arch bridge of masonry with bricks staggered across its depth, in space";
    }
}

impl Scenario {
    /// Reads a scenario from TOML.
    ///
    /// # Errors
    /// If the text is no scenario, with line and column.
    pub fn parse(text: &str) -> Result<Self, MeshingError> {
        toml::from_str(text).map_err(|error| MeshingError::Scenario(error.to_string()))
    }

    /// Reads a scenario file.
    ///
    /// # Errors
    /// If it cannot be read or is no scenario.
    pub fn read(path: &Path) -> Result<Self, MeshingError> {
        let text = std::fs::read_to_string(path)
            .map_err(|source| MeshingError::Io { path: path.to_path_buf(), source })?;
        Self::parse(&text)
    }

    /// The structure's name and generator.
    ///
    /// # Errors
    /// If none or more than one is described.
    pub fn kind(&self) -> Result<(&'static str, AnyKind<'_>), MeshingError> {
        let found = self.kinds();
        let names = |kinds: &[(&'static str, &str)]| {
            kinds.iter().map(|(name, _)| format!("[{name}]")).collect::<Vec<_>>().join(", ")
        };
        match found.as_slice() {
            [one] => Ok(*one),
            [] => Err(MeshingError::Scenario(format!(
                "there is no structure: one table of {} is needed",
                names(Self::KINDS)
            ))),
            [(a, _), (b, _), ..] => Err(MeshingError::Scenario(format!(
                "there are two structures, [{a}] and [{b}]: a scenario describes one"
            ))),
        }
    }

    pub(super) fn check(&self) -> Result<(), MeshingError> {
        for (name, value) in [
            ("run.step_s", self.run.step_s),
            ("run.end_s", self.run.end_s),
            ("run.output_s", self.run.output_s),
        ] {
            value.map_or(Ok(()), |value| positive(name, value))?;
        }
        not_negative("run.contact_buffer_m", self.run.contact_buffer_m.unwrap_or(0.0))?;
        if let Some(interval) = self.run.monitor_interval {
            count("run.monitor_interval", interval.min(2), 1)?;
        }
        Ok(())
    }
}
