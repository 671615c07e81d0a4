//! Walls of bricks.

use super::check_size;
use crate::meshing::{
    MeshingError,
    model::{Bond, Drive, Joints, Motion, Substance},
    properties::{Joint, Material, check_elements, count, not_negative, positive},
    spatial::{mesh::SpatialMesh, model::SpatialModel},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A wall of bricks in bond, one or more leaves deep, clamped below. After a while its top is
/// driven over some length. Bricks touch each other, or are joined by mortar. The origin is at the
/// lower corner in front; x runs along, y across, z up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Wall3d {
    /// Length, width and height of a brick \[m\].
    pub brick_m: [f64; 3],
    /// Bricks of a course and leaf, as stretchers.
    pub bricks: usize,
    /// Courses.
    pub courses: usize,
    /// Leaves: widths of bricks across the wall.
    pub leaves: usize,
    /// How bricks lie on each other.
    pub bond: BrickBond,
    /// Cells of a brick along its length, width and height, six tetrahedra each. Parts of bricks
    /// have parts of them, one at least.
    pub cells: [usize; 3],
    /// Whether joints break between all tetrahedra: `inside` those of a brick, `mortar` between
    /// bricks. If not, bricks touch each other only.
    pub bonded: bool,
    /// Whether mortared bricks touch only where mortar or bricks have cracked, as far as `ypsilon run
    /// --profile source` follows it; if not, all tetrahedra touch from the start.
    pub contact_at_cracks: bool,
    /// Joints between tetrahedra of a brick.
    pub inside: Joint,
    /// Joints between bricks.
    pub mortar: Joint,
    /// Velocity of the driven part of the top \[m/s\]; directions with 0 are free.
    pub push_m_s: [f64; 3],
    /// Length of the driven part of the top, in the middle \[m\].
    pub push_width_m: f64,
    /// When the push begins \[s\].
    pub settle_s: f64,
    /// How long it lasts \[s\]; it reaches its velocity in a tenth of that.
    pub push_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// The bricks.
    pub material: Material,
}

/// How bricks lie on each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BrickBond {
    /// Stretchers, shifted by half a brick from course to course and from leaf to leaf.
    #[default]
    Running,
    /// Headers across two leaves, shifted by half their width from course to course.
    Header,
    /// Courses of stretchers and of headers in turn.
    English,
}

impl Default for Wall3d {
    /// A wall of two leaves in English bond.
    fn default() -> Self {
        Wall3d {
            brick_m: [0.2, 0.1, 0.06],
            bricks: 6,
            courses: 8,
            leaves: 2,
            bond: BrickBond::English,
            cells: [1; 3],
            bonded: false,
            contact_at_cracks: false,
            inside: Joint::inside_stone(),
            mortar: Joint::default(),
            push_m_s: [0.0, 0.1, 0.0],
            push_width_m: 0.4,
            settle_s: 0.1,
            push_s: 0.2,
            gravity_m_s2: -9.81,
            material: Material {
                young_pa: 0.5e9,
                density_kg_m3: 2000.0,
                friction: 0.6,
                penalty_pa: 0.5e9,
                tangential_penalty_pa: 0.25e9,
                ..Material::default()
            },
        }
    }
}

/// Quarters of a brick's length: the unit along the wall.
const QUARTERS: usize = 4;

/// A brick: from where to where along (quarters of a brick), across (leaves), and its course.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Brick {
    along: [usize; 2],
    across: [usize; 2],
    course: usize,
}

impl Wall3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        self.check()?;
        let [nx, ny, nz] = self.cells;
        check_elements(0, &[6, self.bricks, self.leaves, self.courses, nx, ny, nz])?;
        let bricks = self.layout();
        let mut mesh = SpatialMesh::default();
        if self.bonded {
            self.add_bonded(&mut mesh, &bricks)?;
        } else {
            for brick in &bricks {
                let [low, high] = [0, 1].map(|end| {
                    let course = brick.course + end;
                    self.place([brick.along[end], brick.across[end], course], [QUARTERS, 1, 1])
                });
                mesh.add_box([low, high], self.cells_of(brick), 0)?;
            }
        }
        let [length, width, height] = self.brick_m;
        let size =
            [length * self.bricks as f64, width * self.leaves as f64, height * self.courses as f64];
        let volume = size.iter().product();
        let materials = vec![("bricks", self.material)];
        let mut model = SpatialModel::of_bodies("wall of bricks", mesh, volume, materials);
        if self.bonded {
            let (material, bond) = (self.material, Bond::Blocks);
            model.substances = vec![Substance { name: "bricks", material, bond }];
            model.joints = Some(Joints { inside: self.inside, mortar: self.mortar });
            model.contact_at_cracks = self.contact_at_cracks;
            model.bodies = 1;
        }
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = self.settle_s + self.push_s;
        let base = model.nodes_where(|[_, _, z]| z == 0.0);
        model.hold("base", base, Motion::CLAMPED);
        self.push(&mut model, size);
        model.notes = vec![format!("{} bricks", bricks.len())];
        Ok(model)
    }

    fn check(&self) -> Result<(), MeshingError> {
        check_size("wall-3d.brick_m", self.brick_m)?;
        count("wall-3d.bricks", self.bricks, 1)?;
        count("wall-3d.courses", self.courses, 1)?;
        count("wall-3d.leaves", self.leaves, 1)?;
        self.cells.iter().try_for_each(|&n| count("wall-3d.cells", n, 1))?;
        not_negative("wall-3d.push_width_m", self.push_width_m)?;
        positive("wall-3d.settle_s", self.settle_s)?;
        positive("wall-3d.push_s", self.push_s)?;
        self.material.check("wall-3d.material")?;
        self.inside.check("wall-3d.inside")?;
        self.mortar.check("wall-3d.mortar")?;
        if self.bond != BrickBond::Running && self.leaves % 2 == 1 {
            let expected = "an even number is needed: headers lie across two leaves";
            return Err(MeshingError::parameter("wall-3d.leaves", self.leaves, expected));
        }
        Ok(())
    }

    /// All bricks, course by course.
    fn layout(&self) -> Vec<Brick> {
        let end = QUARTERS * self.bricks;
        let mut bricks = Vec::new();
        for course in 0..self.courses {
            let headers = match self.bond {
                BrickBond::Running => false,
                BrickBond::Header => true,
                BrickBond::English => course % 2 == 1,
            };
            let deep = if headers { 2 } else { 1 };
            let long = QUARTERS / deep;
            for row in 0..self.leaves / deep {
                // headers between stretchers lie half a header beside their joints
                let shifted = match self.bond {
                    BrickBond::English => headers,
                    _ => (course + row) % 2 == 1,
                };
                let mut from = 0;
                while from < end {
                    let whole = if from == 0 && shifted { long / 2 } else { long };
                    let to = (from + whole).min(end);
                    let across = [deep * row, deep * (row + 1)];
                    bricks.push(Brick { along: [from, to], across, course });
                    from = to;
                }
            }
        }
        bricks
    }

    /// A place by its number of steps along, across and up, so many of which make a brick.
    fn place(&self, steps: [usize; 3], per_brick: [usize; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| self.brick_m[k] * (steps[k] as f64 / per_brick[k] as f64))
    }

    /// Cells of a brick along, across and up.
    fn cells_of(&self, brick: &Brick) -> [usize; 3] {
        let [along, across] = [brick.along, brick.across].map(|[from, to]| to - from);
        [(along * self.cells[0]).div_ceil(QUARTERS), across * self.cells[1], self.cells[2]]
    }

    /// Bricks whose tetrahedra share nodes with their neighbours': all cells are those of one
    /// grid.
    fn add_bonded(&self, mesh: &mut SpatialMesh, bricks: &[Brick]) -> Result<(), MeshingError> {
        let cells = self.cells;
        let mut numbers: BTreeMap<[usize; 3], usize> = BTreeMap::new();
        for (block, brick) in bricks.iter().enumerate() {
            let along = brick.along.map(|quarters| quarters * cells[0]);
            if along.iter().any(|n| n % QUARTERS != 0) {
                let expected = "the first is to be a multiple of 2, of 4 with headers, so that \
                                mortar runs along faces of cells";
                let cells = format!("{cells:?}");
                return Err(MeshingError::parameter("wall-3d.cells", cells, expected));
            }
            let [x, y] = [along.map(|n| n / QUARTERS), brick.across.map(|n| n * cells[1])];
            let z = [brick.course * cells[2], (brick.course + 1) * cells[2]];
            for (k, j, i) in (z[0]..z[1])
                .flat_map(|k| (y[0]..y[1]).map(move |j| (k, j)))
                .flat_map(|(k, j)| (x[0]..x[1]).map(move |i| (k, j, i)))
            {
                let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|c: usize| {
                    let at = [i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)];
                    *numbers.entry(at).or_insert_with(|| {
                        mesh.nodes.push(self.place(at, cells));
                        mesh.nodes.len() - 1
                    })
                });
                mesh.add_cell(|c| corners[c], block, 0);
            }
        }
        mesh.blocks = bricks.len();
        Ok(())
    }

    /// Drives the middle of the top.
    fn push(&self, model: &mut SpatialModel, [length, _, height]: [f64; 3]) {
        let most = self.push_width_m / 2.0;
        let is_pushed =
            |[x, _, z]: [f64; 3]| z >= height * (1.0 - 1e-12) && (x - length / 2.0).abs() <= most;
        let nodes = model.nodes_where(is_pushed);
        if nodes.is_empty() || self.push_m_s == [0.0; 3] {
            return;
        }
        let drives =
            self.push_m_s.map(|v| if v == 0.0 { Drive::Force(0.0) } else { Drive::Velocity(v) });
        let full = self.settle_s + 0.1 * self.push_s;
        let history = vec![[0.0, 0.0], [self.settle_s, 0.0], [full, 1.0]];
        model.hold("pushed", nodes, Motion { drives, later: None, history });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn walls() -> Vec<Wall3d> {
        let mut walls = Vec::new();
        for bond in [BrickBond::Running, BrickBond::Header, BrickBond::English] {
            for (bonded, cells) in [(false, [1; 3]), (false, [2, 1, 2]), (true, [4, 1, 1])] {
                walls.push(Wall3d { bond, bonded, cells, ..Wall3d::default() });
            }
        }
        walls
    }

    #[test]
    fn every_bond_fills_the_wall_with_six_tetrahedra_a_brick_at_least() {
        for wall in walls() {
            let model = wall.model().expect("a model");
            model.check().unwrap_or_else(|error| panic!("{wall:?}: {error}"));
            let mut of_block = vec![0; model.mesh.blocks];
            model.mesh.tetrahedra.iter().for_each(|t| of_block[t.block] += 1);
            assert!(of_block.iter().all(|&n| n >= 6), "{wall:?}");
        }
    }

    /// Joints across the bed of a course never continue in the next one.
    #[test]
    fn vertical_joints_do_not_run_through() {
        for wall in walls() {
            let bricks = wall.layout();
            let ends = |course: usize, leaf: usize| -> BTreeSet<usize> {
                let mine =
                    |b: &&Brick| b.course == course && (b.across[0]..b.across[1]).contains(&leaf);
                let end = QUARTERS * wall.bricks;
                bricks.iter().filter(mine).map(|b| b.along[1]).filter(|&x| x < end).collect()
            };
            for leaf in 0..wall.leaves {
                for course in 1..wall.courses {
                    let (here, below) = (ends(course, leaf), ends(course - 1, leaf));
                    assert!(here.is_disjoint(&below), "{:?}, course {course}", wall.bond);
                }
            }
        }
    }

    #[test]
    fn headers_need_pairs_of_leaves() {
        let error = Wall3d { leaves: 3, ..Wall3d::default() }.model().expect_err("a fault");
        assert!(error.to_string().contains("wall-3d.leaves = 3"), "{error}");
    }
}
