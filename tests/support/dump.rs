//! Full-precision records of the originals of the classic dialect and of Y-Geo:
//! lines N node, T triangle, J joint, C couple.

use std::{
    fmt::Write as _,
    fs,
    io::{self, Read as _},
    path::Path,
};
use ypsilon::{
    scene::{CohesiveModel, JointKind},
    simulation::Simulation,
};

/// Records of one instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Dump {
    /// Letter and numbers of each line.
    pub lines: Vec<(char, Vec<f64>)>,
}

/// How far two dumps are apart.
#[derive(Debug, Clone, Default)]
pub struct Comparison {
    /// Numbers that differ in a bit.
    pub different: usize,
    /// Largest difference of a number relative to the largest in its column.
    pub worst: f64,
    /// The first difference, in words.
    pub first: String,
}

impl Dump {
    /// Reads a record of the original, compressed or not.
    pub fn read(path: &Path) -> io::Result<Self> {
        let bytes = fs::read(path)?;
        let mut text = String::new();
        if path.extension().is_some_and(|e| e == "gz") {
            flate2::read::GzDecoder::new(&*bytes).read_to_string(&mut text)?;
        } else {
            (&*bytes).read_to_string(&mut text)?;
        }
        Self::parse(&text)
    }

    /// Parses the text of a record.
    pub fn parse(text: &str) -> io::Result<Self> {
        let bad = |line: &str| {
            io::Error::new(io::ErrorKind::InvalidData, format!("cannot read `{line}`"))
        };
        let mut lines = Vec::new();
        for line in text.lines().filter(|line| !line.starts_with('#')) {
            let mut words = line.split_whitespace();
            let letter = words.next().and_then(|w| w.chars().next()).ok_or_else(|| bad(line))?;
            let numbers = words.map(str::parse).collect::<Result<Vec<f64>, _>>();
            lines.push((letter, numbers.map_err(|_| bad(line))?));
        }
        Ok(Self { lines })
    }

    /// The same records of a simulation. Before the first forces (`fresh`)
    /// strengths and stresses have no values yet.
    pub fn of(simulation: &Simulation, fresh: bool) -> Self {
        let mut lines = Vec::new();
        let scene = simulation.scene();
        let is_classic = scene.conventions.cohesive == CohesiveModel::Classic;
        for n in 0..scene.nodes.len() {
            let (x, v) = (scene.nodes.current[n], scene.nodes.velocity[n]);
            let f = simulation.forces()[n];
            let mut row = vec![n as f64, x.x, x.y, v.x, v.y, f.x, f.y];
            if is_classic {
                let contact = simulation.contact_forces()[n];
                row.extend([contact.x, contact.y]);
            }
            let mass = if fresh { 0.0 } else { simulation.masses()[n] };
            row.extend([
                mass,
                f64::from(scene.nodes.set[n]),
                f64::from(scene.nodes.boundary_flag[n]),
            ]);
            lines.push(('N', row));
        }
        for e in 0..scene.elements.len() {
            lines.push(element(simulation, e, fresh));
        }
        lines.extend(simulation.couples().into_iter().map(|(pair, sliding)| {
            let mut row = pair.map(f64::from).to_vec();
            row.extend(sliding);
            ('C', row)
        }));
        Self { lines }
    }

    /// Compares with another dump; `letters` are the kinds of lines that count.
    pub fn compare(&self, other: &Self, letters: &str) -> Comparison {
        let mut comparison = Comparison::default();
        let chosen = |d: &Self| -> Vec<(char, Vec<f64>)> {
            d.lines.iter().filter(|(l, _)| letters.contains(*l)).cloned().collect()
        };
        let (a, b) = (chosen(self), chosen(other));
        let mut scales = std::collections::HashMap::new();
        for (letter, row) in &a {
            for (column, value) in row.iter().enumerate() {
                let scale: &mut f64 = scales.entry((*letter, column)).or_insert(0.0);
                *scale = scale.max(value.abs());
            }
        }
        let shape = |d: &[(char, Vec<f64>)]| -> Vec<(char, usize)> {
            d.iter().map(|(l, row)| (*l, row.len())).collect()
        };
        if shape(&a) != shape(&b) {
            comparison.worst = f64::INFINITY;
            comparison.first = format!("{} against {} lines", a.len(), b.len());
            comparison.different = 1;
            return comparison;
        }
        for ((letter, left), (_, right)) in a.iter().zip(&b) {
            for (column, (x, y)) in left.iter().zip(right).enumerate() {
                // the sign of a sliding that is zero has no effect
                let zeros = *letter == 'C' && x == y;
                let same = x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan()) || zeros;
                if same {
                    continue;
                }
                comparison.different += 1;
                let scale = scales[&(*letter, column)];
                let far = (x - y).abs() / if scale > 0.0 { scale } else { 1.0 };
                comparison.worst =
                    comparison.worst.max(if far.is_nan() { f64::INFINITY } else { far });
                if comparison.first.is_empty() {
                    let _ = write!(
                        comparison.first,
                        "{letter} {} column {column}: {x:e} against {y:e}",
                        left[0]
                    );
                }
            }
        }
        comparison
    }
}

fn element(simulation: &Simulation, e: usize, fresh: bool) -> (char, Vec<f64>) {
    let scene = simulation.scene();
    let elements = &scene.elements;
    let kind = elements.joint_kind[e];
    let code = scene.conventions.property_code(elements.property[e], kind, scene.materials.len());
    let mut row = vec![e as f64, f64::from(code)];
    let classic = simulation.classic_joints();
    if kind == JointKind::NoJoint {
        row.extend(elements.nodes[e][..3].iter().map(|&n| f64::from(n)));
        if let Some(joints) = classic {
            row.extend(joints.joints_around(e).map(f64::from));
            let stress = simulation.stresses()[e];
            row.extend([stress[(0, 0)], stress[(0, 1)], stress[(1, 1)]]);
        }
        return ('T', row);
    }
    if classic.is_some() {
        row.push(f64::from(kind as i32));
    }
    row.extend(elements.nodes[e][..4].iter().map(|&n| f64::from(n)));
    let [first, second] = elements.sides[e];
    if let Some(joints) = classic {
        row.extend([first, second].map(f64::from));
        row.extend(if fresh { [0.0; 3] } else { joints.strengths(e) });
        let aperture = joints.aperture(e).copied().unwrap_or_default();
        row.extend([
            aperture.normal_stress,
            aperture.shear_stress,
            aperture.current,
            aperture.failure_mode,
        ]);
    } else {
        let second = if kind == JointKind::FreeEdge { -1 } else { second };
        row.extend([first, second].map(f64::from));
        row.push(if fresh { 0.0 } else { simulation.joint_strength(e) });
        let failed = simulation.failures().iter().find(|f| f.element == e).map_or(0.0, |f| f.mode);
        let yielding = simulation.joint_record(e).map_or(0, |r| r.yielding.mode as i32);
        row.extend([failed, f64::from(yielding)]);
    }
    ('J', row)
}
