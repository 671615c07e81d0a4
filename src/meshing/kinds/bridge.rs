//! Arch bridges of masonry.

use crate::meshing::{
    MeshingError,
    mesh::{Division, divide_mirrored, flip_right_half},
    model::{Bond, Joints, Model, Motion, Substance, Support},
    pattern::{Pattern, Point, area, line},
    properties::{Joint, Material, check_elements, count, not_negative, positive},
    tidy::tidy,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An arch bridge: a semicircular ring of voussoirs on footings, spandrels in courses above and
/// beside it, soil at both ends. The origin is on the ground under the keystone.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Bridge {
    /// Length of the masonry L \[m\].
    pub span_m: f64,
    /// Height of the masonry H \[m\].
    pub height_m: f64,
    /// Inner diameter of the arch D \[m\].
    pub arch_diameter_m: f64,
    /// Height of the arch's centre above the ground \[m\]; 0.3 R if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre_height_m: Option<f64>,
    /// Thickness of the ring \[m\].
    pub ring_thickness_m: f64,
    /// Number of voussoirs, odd; about as long as the blocks if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub voussoirs: Option<usize>,
    /// Blocks of each footing, one on the other; about as high as courses if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub footing_blocks: Option<usize>,
    /// Courses over the whole height.
    pub courses: usize,
    /// Length of a block \[m\]; the nearest one of which a whole number fills the span.
    pub block_length_m: f64,
    /// How blocks lie on those below.
    pub bond: BlockBond,
    /// Triangles of a block without neighbours' corners on its edges: 2, or 4 around its middle.
    pub triangles_per_block: usize,
    /// Whether the triangles of the right half mirror those of the left one; if not, blocks of
    /// the right half are divided along their other diagonals.
    pub symmetric: bool,
    /// Width of the soil at each end \[m\]; 0 for none.
    pub soil_width_m: f64,
    /// What is thinner than this is closed \[m\]; 0.35 of a course if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub smallest_m: Option<f64>,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// The blocks.
    pub stone: Material,
    /// The soil.
    pub soil: Material,
    /// Joints between triangles of a block.
    pub inside: Joint,
    /// Joints between blocks.
    pub mortar: Joint,
}

/// How the blocks of a course lie on those of the course below.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BlockBond {
    /// Shifted by half a block.
    #[default]
    Running,
    /// Not shifted.
    Stack,
}

impl Default for Bridge {
    /// The bridge with D = 0.5 L.
    fn default() -> Self {
        Bridge {
            span_m: 16.6,
            height_m: 9.0,
            arch_diameter_m: 8.3,
            centre_height_m: None,
            ring_thickness_m: 0.45,
            voussoirs: None,
            footing_blocks: None,
            courses: 15,
            block_length_m: 0.5,
            bond: BlockBond::Running,
            triangles_per_block: 2,
            symmetric: true,
            soil_width_m: 2.0,
            smallest_m: None,
            gravity_m_s2: -9.81,
            stone: Material::default(),
            soil: Material::soil(),
            inside: Joint::inside_stone(),
            mortar: Joint::default(),
        }
    }
}

const STONE: usize = 0;
const SOIL: usize = 1;

impl Bridge {
    /// The bridge's model.
    ///
    /// # Errors
    /// If a parameter has no sense or the blocks cannot be made.
    pub fn model(&self) -> Result<Model, MeshingError> {
        let shape = Shape::of(self)?;
        let mut pattern = Pattern::default();
        shape.ring(&mut pattern);
        shape.spandrel(&mut pattern, self.bond);
        if self.soil_width_m > 0.0 {
            shape.soil(&mut pattern, self.soil_width_m);
        }
        shape.mark_ring(&mut pattern);
        pattern.conform();
        let gone = tidy(&mut pattern, shape.smallest);
        pattern.conform();
        pattern.check_areas()?;
        let division =
            if self.triangles_per_block == 4 { Division::Middle } else { Division::Fewest };
        let mut mesh = divide_mirrored(&pattern, division)?;
        if !self.symmetric {
            flip_right_half(&mut mesh);
        }
        let opening = area(&shape.opening());
        let masonry = self.span_m * self.height_m - opening;
        let soil = 2.0 * self.soil_width_m * self.height_m;
        let substance = |name, material, bond| Substance { name, material, bond };
        let notes = vec![
            format!(
                "{} voussoirs, {} blocks in each footing, {} + {} courses below and above the \
                 ring, blocks of {:.4} m",
                shape.voussoirs,
                shape.footing_blocks,
                shape.lower,
                shape.courses.len() - 1 - shape.lower,
                shape.block_length,
            ),
            format!("{gone} blocks of each half closed because they were too small"),
        ];
        let mut model = Model {
            title: format!(
                "arch bridge, L = {} m, H = {} m, D = {} m",
                self.span_m, self.height_m, self.arch_diameter_m
            ),
            mesh,
            substances: vec![
                substance("stone", self.stone, Bond::Blocks),
                substance("soil", self.soil, Bond::Continuous),
            ],
            joints: Some(Joints { inside: self.inside, mortar: self.mortar }),
            supports: Vec::new(),
            top: Vec::new(),
            velocities: Default::default(),
            start: Default::default(),
            area: masonry + soil,
            bodies: 1,
            second_stage_s: None,
            settled_s: 1.5,
            gravity_m_s2: self.gravity_m_s2,
            notes,
        };
        let half = shape.half;
        let far = half + self.soil_width_m;
        let support =
            |name: &str, nodes| Support { name: name.to_owned(), nodes, motion: Motion::CLAMPED };
        model.supports = vec![
            support("base left", model.nodes_where(|[x, y]| y == 0.0 && x < 0.0 && x >= -half)),
            support("base right", model.nodes_where(|[x, y]| y == 0.0 && x > 0.0 && x <= half)),
        ];
        if self.soil_width_m > 0.0 {
            // the corner below the end of the masonry stays with the masonry
            let fixed = |[x, y]: Point| x.abs() == far || (y == 0.0 && x.abs() > half);
            model.supports.push(support("soil, held", model.nodes_where(fixed)));
        }
        let mut top = model.nodes_where(|[x, y]| y == self.height_m && x.abs() <= half);
        top.sort_by(|&a, &b| model.mesh.nodes[a][0].total_cmp(&model.mesh.nodes[b][0]));
        model.top = top;
        Ok(model)
    }
}

/// The numbers that the geometry follows from. Everything is the left half, x ≤ 0.
struct Shape {
    half: f64,
    height: f64,
    radius: f64,
    outer: f64,
    centre: f64,
    voussoirs: usize,
    footing_blocks: usize,
    /// Heights of the course lines.
    courses: Vec<f64>,
    /// Number of courses up to the top of the keystone.
    lower: usize,
    block_length: f64,
    blocks: usize,
    smallest: f64,
    /// Inner and outer corners of the voussoirs, from the springer to the keystone.
    inner: Vec<Point>,
    chain: Vec<Point>,
}

impl Shape {
    fn of(bridge: &Bridge) -> Result<Self, MeshingError> {
        let name = |key: &str| format!("bridge.{key}");
        for (key, value) in [
            ("span_m", bridge.span_m),
            ("height_m", bridge.height_m),
            ("arch_diameter_m", bridge.arch_diameter_m),
            ("ring_thickness_m", bridge.ring_thickness_m),
            ("block_length_m", bridge.block_length_m),
        ] {
            positive(&name(key), value)?;
        }
        not_negative(&name("soil_width_m"), bridge.soil_width_m)?;
        bridge.stone.check("bridge.stone")?;
        bridge.soil.check("bridge.soil")?;
        bridge.inside.check("bridge.inside")?;
        bridge.mortar.check("bridge.mortar")?;
        let radius = bridge.arch_diameter_m / 2.0;
        let outer = radius + bridge.ring_thickness_m;
        let half = bridge.span_m / 2.0;
        let centre = bridge.centre_height_m.unwrap_or(0.3 * radius);
        positive(&name("centre_height_m"), centre)?;
        count(&name("courses"), bridge.courses, 2)?;
        let course = bridge.height_m / bridge.courses as f64;
        let smallest = bridge.smallest_m.unwrap_or(0.35 * course);
        positive(&name("smallest_m"), smallest)?;
        if outer + 2.0 * smallest > half {
            let expected = format!("arch and ring must fit into the span of {}", bridge.span_m);
            return Err(MeshingError::parameter(
                &name("arch_diameter_m"),
                bridge.arch_diameter_m,
                &expected,
            ));
        }
        let blocks = (bridge.span_m / bridge.block_length_m).round().max(1.0);
        count(&name("span_m / block_length_m"), blocks as usize, 2)?;
        check_elements(0, &[4, bridge.courses, blocks as usize])?;
        let block_length = bridge.span_m / blocks;
        let arc = std::f64::consts::PI * (radius + outer) / 2.0;
        let near_odd = 2 * (arc / block_length / 2.0).floor() as usize + 1;
        let voussoirs = bridge.voussoirs.unwrap_or(near_odd.max(3));
        count(&name("voussoirs"), voussoirs, 3)?;
        if voussoirs.is_multiple_of(2) {
            let expected = "an odd number, so that one of them is the keystone";
            return Err(MeshingError::parameter(&name("voussoirs"), voussoirs, expected));
        }
        let footing_blocks =
            bridge.footing_blocks.unwrap_or(((centre / course).round() as usize).max(1));
        count(&name("footing_blocks"), footing_blocks, 1)?;
        if !matches!(bridge.triangles_per_block, 2 | 4) {
            let expected = "2 or 4";
            return Err(MeshingError::parameter(
                &name("triangles_per_block"),
                bridge.triangles_per_block,
                expected,
            ));
        }
        let on_ring = |radius: f64| {
            (0..=voussoirs / 2).map(move |k| {
                let angle = std::f64::consts::PI * k as f64 / voussoirs as f64;
                let [x, y] = [-radius * angle.cos(), centre + radius * angle.sin()];
                if k == 0 { [-radius, centre] } else { [x, y] }
            })
        };
        let (inner, chain): (Vec<Point>, Vec<Point>) =
            (on_ring(radius).collect(), on_ring(outer).collect());
        let key = chain[chain.len() - 1][1];
        if key + 2.0 * smallest > bridge.height_m {
            let expected = format!("the ring ends at {key:.3} m and needs a course above it");
            return Err(MeshingError::parameter(&name("height_m"), bridge.height_m, &expected));
        }
        let above = (((bridge.height_m - key) / course).round() as usize).max(1);
        let lower = bridge.courses.saturating_sub(above).max(1);
        let mut courses: Vec<f64> = (0..lower).map(|k| key * k as f64 / lower as f64).collect();
        let step = (bridge.height_m - key) / above as f64;
        courses.extend((0..above).map(|k| key + step * k as f64));
        courses.push(bridge.height_m);
        Ok(Shape {
            half,
            height: bridge.height_m,
            radius,
            outer,
            centre,
            voussoirs,
            footing_blocks,
            courses,
            lower,
            block_length,
            blocks: blocks as usize,
            smallest,
            inner,
            chain,
        })
    }

    /// The whole opening: a polygon, as the voussoirs are straight.
    fn opening(&self) -> Vec<Point> {
        let left = self.inner.iter().rev().copied();
        let right = self.inner.iter().map(|&[x, y]| [-x, y]);
        [[-self.radius, 0.0], [self.radius, 0.0]].into_iter().chain(right).chain(left).collect()
    }

    /// Voussoirs and footing.
    fn ring(&self, pattern: &mut Pattern) {
        let fixed = line::FIXED;
        let ring = fixed | line::RING;
        for k in 1..self.inner.len() {
            let corners = [
                (self.inner[k - 1], fixed),
                (self.inner[k], fixed),
                (self.chain[k], ring),
                (self.chain[k - 1], ring),
            ];
            pattern.block(&corners, STONE, false);
        }
        let last = self.inner.len() - 1;
        let (inner, outer) = (self.inner[last], self.chain[last]);
        let keystone = [
            (outer, ring),
            (inner, fixed),
            ([0.0, inner[1]], fixed | line::CENTRE),
            ([0.0, outer[1]], line::RING | line::CENTRE),
        ];
        pattern.block(&keystone, STONE, true);
        let level = |k: usize| {
            if k == self.footing_blocks {
                self.centre
            } else {
                self.centre * k as f64 / self.footing_blocks as f64
            }
        };
        for k in 0..self.footing_blocks {
            let ground = if k == 0 { line::BOTTOM } else { 0 };
            let corners = [
                ([-self.outer, level(k)], ring | ground),
                ([-self.radius, level(k)], fixed | ground),
                ([-self.radius, level(k + 1)], fixed),
                ([-self.outer, level(k + 1)], ring),
            ];
            pattern.block(&corners, STONE, false);
        }
    }

    /// Blocks in courses, cut by the ring.
    fn spandrel(&self, pattern: &mut Pattern, bond: BlockBond) {
        let mut outside: Vec<Point> = vec![[-self.half, 0.0], [-self.outer, 0.0]];
        outside.extend(&self.chain);
        let key = self.chain[self.chain.len() - 1][1];
        outside.extend([[0.0, key], [0.0, self.height], [-self.half, self.height]]);
        for (row, levels) in self.courses.windows(2).enumerate() {
            // the uppermost course has whole blocks at its ends
            let from_top = self.courses.len() - 2 - row;
            let shifted = bond == BlockBond::Running && from_top % 2 == 1;
            for [from, to, centred] in self.columns(shifted) {
                let lower = [from, levels[0]];
                let upper = [to, levels[1]];
                let corners: Vec<(Point, u32)> = clip(&outside, lower, upper)
                    .into_iter()
                    .map(|p| (p, self.lines_at(p)))
                    .collect();
                pattern.block(&corners, STONE, centred != 0.0);
            }
        }
    }

    /// Left and right end of the blocks of a course in the left half, and whether (not 0) they go
    /// on across the line of symmetry.
    fn columns(&self, shifted: bool) -> Vec<[f64; 3]> {
        let first = if shifted { self.block_length / 2.0 } else { 0.0 };
        let mut ends = vec![-self.half];
        for k in 0..=self.blocks {
            let x = -self.half + first + k as f64 * self.block_length;
            if x > -self.half + 1e-9 && x < -1e-9 {
                ends.push(x);
            }
        }
        // an even number of halves left of the middle ends a block there
        let joint_in_middle = self.blocks.is_multiple_of(2) != shifted;
        ends.push(0.0);
        ends.windows(2)
            .map(|w| {
                let across = w[1] == 0.0 && !joint_in_middle;
                [w[0], w[1], if across { 1.0 } else { 0.0 }]
            })
            .collect()
    }

    fn soil(&self, pattern: &mut Pattern, width: f64) {
        let columns = (width / (2.0 * self.block_length)).round().max(1.0) as usize;
        let far = -self.half - width;
        let at = |k: usize| {
            if k == columns { -self.half } else { far + width * k as f64 / columns as f64 }
        };
        for levels in self.courses.windows(2) {
            for k in 0..columns {
                let corners = [
                    [at(k), levels[0]],
                    [at(k + 1), levels[0]],
                    [at(k + 1), levels[1]],
                    [at(k), levels[1]],
                ];
                let corners = corners.map(|p| (p, self.lines_at(p) | line::FIXED));
                pattern.block(&corners, SOIL, false);
            }
        }
    }

    /// Lines that a point lies on, the ring excepted.
    fn lines_at(&self, [x, y]: Point) -> u32 {
        let on = |here: bool, line: u32| if here { line } else { 0 };
        let outline = on(x == 0.0, line::CENTRE)
            | on(y == 0.0, line::BOTTOM)
            | on(y == self.height, line::TOP)
            | on(x == -self.half, line::END);
        // corners of the outline stay
        outline | on(outline.count_ones() > 1, line::FIXED)
    }

    /// Marks the points on the outer face of ring and footing.
    fn mark_ring(&self, pattern: &mut Pattern) {
        let mut face = vec![[-self.outer, 0.0]];
        face.extend(&self.chain);
        let key = self.chain[self.chain.len() - 1][1];
        face.push([0.0, key]);
        for (p, lines) in pattern.points.iter().zip(&mut pattern.lines) {
            let on = face.windows(2).any(|edge| {
                let (along, length) = crate::meshing::pattern::foot(*p, edge[0], edge[1]);
                let at = [
                    edge[0][0] + along * (edge[1][0] - edge[0][0]),
                    edge[0][1] + along * (edge[1][1] - edge[0][1]),
                ];
                let beyond = 1e-9 / length;
                (-beyond..=1.0 + beyond).contains(&along)
                    && crate::meshing::pattern::distance(at, *p) < 1e-9
            });
            if on {
                *lines |= line::RING;
            }
        }
    }
}

/// The part of a polygon within a rectangle (Sutherland and Hodgman).
fn clip(polygon: &[Point], lower: Point, upper: Point) -> Vec<Point> {
    let mut corners = polygon.to_vec();
    for (axis, bound, keep_above) in
        [(0, lower[0], true), (0, upper[0], false), (1, lower[1], true), (1, upper[1], false)]
    {
        let inside = |p: &Point| if keep_above { p[axis] >= bound } else { p[axis] <= bound };
        let mut kept = Vec::with_capacity(corners.len() + 2);
        for k in 0..corners.len() {
            let (p, q) = (corners[k], corners[(k + 1) % corners.len()]);
            if inside(&p) {
                kept.push(p);
            }
            if inside(&p) != inside(&q) {
                let part = (bound - p[axis]) / (q[axis] - p[axis]);
                let mut at = [p[0] + part * (q[0] - p[0]), p[1] + part * (q[1] - p[1])];
                at[axis] = bound;
                kept.push(at);
            }
        }
        corners = kept;
    }
    corners
}
