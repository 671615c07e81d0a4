//! Property sets: materials by colour and size, and which joints lie between them.

use super::{
    colouring::{SMALL, colours, mean_heights},
    model::{Bond, Model, Substance},
    properties::Material,
};

/// A property set of the deck.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PropertySet {
    /// Index of the material.
    pub substance: usize,
    /// Colour of its blocks: blocks that are neighbours have different ones.
    pub colour: usize,
    /// Whether it holds the small triangles.
    pub small: bool,
    /// The material.
    pub material: Material,
    /// Its viscosity \[Pa s\].
    pub viscosity_pa_s: f64,
}

/// Property sets and the triangles' numbers of them.
#[derive(Debug, Clone, PartialEq)]
pub struct PropertySets {
    /// The sets.
    pub sets: Vec<PropertySet>,
    /// Set of each triangle.
    pub of_triangle: Vec<usize>,
}

/// Joint sets of the deck.
pub(super) const INSIDE: usize = 0;
pub(super) const MORTAR: usize = 1;

impl PropertySets {
    /// The sets of a model: one for each material, colour and size that occurs.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let mesh = &model.mesh;
        let heights = mean_heights(mesh, model.substances.len());
        let colours = colours(mesh);
        let key = |t: &super::mesh::Triangle| {
            let blocks = model.substances[t.material].bond == Bond::Blocks;
            let colour = if blocks && model.joints.is_some() { colours[t.block] } else { 0 };
            (t.material, colour, mesh.height(t) < SMALL * heights[t.material])
        };
        let mut keys: Vec<_> = mesh.triangles.iter().map(key).collect();
        keys.sort_unstable();
        keys.dedup();
        let of_triangle = mesh
            .triangles
            .iter()
            .map(|t| keys.binary_search(&key(t)).unwrap_or_default())
            .collect();
        let set = |&(substance, colour, small): &(usize, usize, bool)| {
            let material = model.substances[substance].material;
            let whole = material.viscosity(heights[substance]);
            let factor = if small { material.small_viscosity_factor } else { 1.0 };
            let viscosity_pa_s = whole * factor;
            PropertySet { substance, colour, small, material, viscosity_pa_s }
        };
        PropertySets { sets: keys.iter().map(set).collect(), of_triangle }
    }

    /// The joint set between two property sets; none where they are not bonded.
    #[must_use]
    pub fn joint_between(&self, model: &Model, p: usize, q: usize) -> Option<usize> {
        model.joints.as_ref().and_then(|_| self.joint_of(&model.substances, p, q))
    }

    /// The same for a model with joints, of which only the substances are known.
    pub(super) fn joint_of(&self, substances: &[Substance], p: usize, q: usize) -> Option<usize> {
        let (a, b) = (self.sets[p], self.sets[q]);
        let bond = |set: &PropertySet| substances[set.substance].bond;
        if bond(&a) == Bond::Continuous || bond(&b) == Bond::Continuous {
            return None;
        }
        let strong = |set: &PropertySet| bond(set) == Bond::Strong;
        let same = (a.substance, a.colour) == (b.substance, b.colour);
        Some(if same || strong(&a) || strong(&b) { INSIDE } else { MORTAR })
    }
}
