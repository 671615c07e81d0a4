//! Walls in running bond between two beams.

use crate::meshing::{
    MeshingError,
    mesh::{Division, divide},
    model::{Bond, Drive, Joints, Model, Motion, Substance, Support},
    pattern::Pattern,
    properties::{Joint, Material, check_elements, count, not_negative, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A wall of bricks in running bond between two beams: the lower one is held; the upper one
/// carries a vertical load, is then locked vertically and moves to the right. The origin is at the
/// lower left corner of the bricks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Wall {
    /// Number of courses.
    pub courses: usize,
    /// Half bricks in a course: 9 are 4.5 bricks.
    pub half_bricks_per_course: usize,
    /// Length of a brick, half a joint at each end included \[m\].
    pub brick_length_m: f64,
    /// Height of a brick, half a joint above and below included \[m\].
    pub brick_height_m: f64,
    /// Height of a beam \[m\].
    pub beam_height_m: f64,
    /// Vertical stress from the upper beam \[Pa\].
    pub vertical_stress_pa: f64,
    /// Time in which it grows \[s\].
    pub load_ramp_s: f64,
    /// When the upper beam is locked vertically and begins to move \[s\].
    pub shear_from_s: f64,
    /// Its velocity to the right \[m/s\].
    pub shear_velocity_m_s: f64,
    /// Time in which it comes to that velocity \[s\].
    pub shear_ramp_s: f64,
    /// How far it moves \[m\].
    pub shear_way_m: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// The bricks.
    pub brick: Material,
    /// The beams.
    pub steel: Material,
    /// Joints between triangles of a brick, and between bricks and beams.
    pub inside: Joint,
    /// Joints between bricks.
    pub mortar: Joint,
}

impl Default for Wall {
    /// The wall of TU Eindhoven.
    fn default() -> Self {
        let brick = Material {
            young_pa: 16.7e9,
            poisson: 0.15,
            density_kg_m3: 2400.0,
            friction: 0.75,
            penalty_pa: 82e9,
            tangential_penalty_pa: 36e9,
            ..Material::default()
        };
        Wall {
            courses: 18,
            half_bricks_per_course: 9,
            brick_length_m: 0.22,
            brick_height_m: 0.06,
            beam_height_m: 0.06,
            vertical_stress_pa: 0.3e6,
            load_ramp_s: 0.05,
            shear_from_s: 0.1,
            shear_velocity_m_s: 0.002,
            shear_ramp_s: 0.02,
            shear_way_m: 0.002,
            gravity_m_s2: -9.81,
            brick,
            steel: Material { young_pa: 210e9, poisson: 0.3, density_kg_m3: 7600.0, ..brick },
            inside: Joint {
                tensile_pa: 2e6,
                cohesion_pa: 2e6,
                friction: 0.75,
                fracture_energy_n_m: 80.0,
                penalty_pa: 141e9,
            },
            // 82 N/mm³ on a joint of half a brick
            mortar: Joint {
                tensile_pa: 0.25e6,
                cohesion_pa: 0.35e6,
                friction: 0.75,
                fracture_energy_n_m: 18.0,
                penalty_pa: 9.02e9,
            },
        }
    }
}

const BRICK: usize = 0;
const STEEL: usize = 1;

impl Wall {
    /// The wall's model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        self.check()?;
        let half = self.brick_length_m / 2.0;
        let width = half * self.half_bricks_per_course as f64;
        let height = self.brick_height_m * self.courses as f64;
        let top = height + self.beam_height_m;
        let mut pattern = Pattern::default();
        let mut rectangle = |x: [usize; 2], [y0, y1]: [f64; 2], material| {
            let [x0, x1] = x.map(|k| k as f64 * half);
            let corners = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
            pattern.block(&corners.map(|p| (p, 0)), material, false);
        };
        for k in 0..self.half_bricks_per_course {
            rectangle([k, k + 1], [-self.beam_height_m, 0.0], STEEL);
        }
        for course in 0..self.courses {
            let levels = [course, course + 1].map(|k| k as f64 * self.brick_height_m);
            let mut from = 0;
            while from < self.half_bricks_per_course {
                let whole = from > 0 || course % 2 == 0;
                let to = (from + if whole { 2 } else { 1 }).min(self.half_bricks_per_course);
                rectangle([from, to], levels, BRICK);
                from = to;
            }
        }
        for k in 0..self.half_bricks_per_course {
            rectangle([k, k + 1], [height, top], STEEL);
        }
        pattern.conform();
        pattern.check_areas()?;
        let mesh = divide(&pattern, Division::Fewest)?;
        let substance = |name, material, bond| Substance { name, material, bond };
        let mut model = Model {
            title: format!("wall of {} courses between beams", self.courses),
            mesh,
            substances: vec![
                substance("brick", self.brick, Bond::Blocks),
                substance("steel", self.steel, Bond::Strong),
            ],
            joints: Some(Joints { inside: self.inside, mortar: self.mortar }),
            supports: Vec::new(),
            top: Vec::new(),
            velocities: Default::default(),
            start: Default::default(),
            area: width * (height + 2.0 * self.beam_height_m),
            bodies: 1,
            second_stage_s: Some(self.shear_from_s),
            settled_s: self.shear_from_s
                + self.shear_ramp_s / 2.0
                + self.shear_way_m / self.shear_velocity_m_s,
            gravity_m_s2: self.gravity_m_s2,
            notes: vec![format!("bricks cover {width} m by {height} m")],
        };
        model.supports = self.supports(&model, height, top, width);
        Ok(model)
    }

    /// The beams: first the load, later the motion.
    fn supports(&self, model: &Model, height: f64, top: f64, width: f64) -> Vec<Support> {
        let copies = model.copies();
        let cell = width / self.half_bricks_per_course as f64;
        let [still, free] = [Drive::Velocity(0.0), Drive::Force(0.0)];
        let later = Some([Drive::Velocity(self.shear_velocity_m_s), still]);
        let lower = Support {
            name: "lower beam".to_owned(),
            nodes: model.nodes_where(|[_, y]| y < 1e-9),
            motion: Motion::CLAMPED,
        };
        let from = self.shear_from_s;
        let shear = [[from, 0.0], [from + self.shear_ramp_s, 1.0]];
        let mut supports = vec![
            lower,
            Support {
                name: "upper beam".to_owned(),
                nodes: model.nodes_where(|[_, y]| y > height - 1e-9 && y < top - 1e-9),
                motion: Motion { drives: [still, free], later, history: shear.to_vec() },
            },
        ];
        let mut history = vec![[0.0, 0.0], [self.load_ramp_s, 1.0], [from - 1e-7, 1.0]];
        history.extend(shear);
        for node in model.nodes_where(|[_, y]| y > top - 1e-9) {
            let x = model.mesh.nodes[node][0];
            let share = if x < 1e-9 || x > width - 1e-9 { 0.5 } else { 1.0 };
            let force = self.vertical_stress_pa * cell * share / copies[node].max(1) as f64;
            let motion =
                Motion { drives: [still, Drive::Force(-force)], later, history: history.clone() };
            let name = "upper beam, loaded".to_owned();
            supports.push(Support { name, nodes: vec![node], motion });
        }
        supports
    }

    fn check(&self) -> Result<(), MeshingError> {
        count("wall.courses", self.courses, 1)?;
        count("wall.half_bricks_per_course", self.half_bricks_per_course, 2)?;
        check_elements(0, &[4, self.courses, self.half_bricks_per_course])?;
        for (name, value) in [
            ("wall.brick_length_m", self.brick_length_m),
            ("wall.brick_height_m", self.brick_height_m),
            ("wall.beam_height_m", self.beam_height_m),
            ("wall.load_ramp_s", self.load_ramp_s),
            ("wall.shear_velocity_m_s", self.shear_velocity_m_s),
            ("wall.shear_ramp_s", self.shear_ramp_s),
            ("wall.shear_way_m", self.shear_way_m),
            ("wall.shear_from_s - load_ramp_s", self.shear_from_s - self.load_ramp_s - 1e-6),
        ] {
            positive(name, value)?;
        }
        not_negative("wall.vertical_stress_pa", self.vertical_stress_pa)?;
        self.brick.check("wall.brick")?;
        self.steel.check("wall.steel")?;
        self.inside.check("wall.inside")?;
        self.mortar.check("wall.mortar")
    }
}
