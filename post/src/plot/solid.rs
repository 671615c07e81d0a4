//! Bodies in space, seen from outside: faces at the surface in one colour each, shaded by where
//! they look, those in front drawn over those behind.
//!
//! Faces are sorted by the distance of their middles (the painter's algorithm): where bodies
//! penetrate each other, or large faces lie beside small ones, a face may hide what is in front of
//! it.

use super::{
    axes::{MEDIUM, SMALL, text},
    colours::{Colour, ColourMap},
    picture::{Anchor, Picture, Shape},
    scale::{Ticks, prefix},
};
use crate::error::PostError;
use std::collections::BTreeMap;

/// Tetrahedra with a number each.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Solid {
    /// Places of the nodes, z upward \[m\].
    pub points: Vec<[f64; 3]>,
    /// Nodes of each tetrahedron, the last one on the side to which the others run
    /// counter-clockwise.
    pub tetrahedra: Vec<[usize; 4]>,
    /// A number for each.
    pub values: Vec<f64>,
}

/// What of a solid is drawn, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct SolidOptions {
    /// Title.
    pub title: String,
    /// What the numbers are.
    pub quantity: String,
    /// Their unit.
    pub unit: String,
    /// Numbers of the first and the last colour; smallest and largest value if not given.
    pub range: Option<[f64; 2]>,
    /// From where it is seen: direction around the vertical and height above the ground \[°\].
    /// At 0 and 0 x runs to the right and y away.
    pub from_deg: [f64; 2],
    /// Width of the picture, pixels.
    pub width: u32,
}

/// A face at the surface.
struct Face {
    nodes: [usize; 3],
    value: f64,
    normal: [f64; 3],
    depth: f64,
}

const MARGIN: f64 = 24.0;
const TOP: f64 = 64.0;
const BAR: f64 = 18.0;
const BAR_ROOM: f64 = 130.0;

/// Draws a solid.
///
/// # Errors
/// If it is empty, arrays do not fit together, or the width makes no sense.
pub fn solid(solid: &Solid, options: &SolidOptions) -> Result<Picture, PostError> {
    if !(200..=10_000).contains(&options.width) {
        let found = options.width.to_string();
        return Err(PostError::words("the width", found, "expected 200 to 10000 pixels"));
    }
    let fits = solid.values.len() == solid.tetrahedra.len()
        && solid.tetrahedra.iter().flatten().all(|&node| node < solid.points.len());
    if !fits {
        let found = format!("{} for {} tetrahedra", solid.values.len(), solid.tetrahedra.len());
        return Err(PostError::words("values and nodes", found, "expected one for each"));
    }
    let view = View::new(options.from_deg);
    let (mut faces, edges) = surface(solid, &view);
    if faces.is_empty() {
        return Err(PostError::Nothing("there is no tetrahedron to be seen".to_owned()));
    }
    faces.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    let values = || faces.iter().map(|face| face.value).filter(|v| v.is_finite());
    let [low, high] = options.range.unwrap_or_else(|| {
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    });
    let high = if high > low { high } else { low + low.abs().max(1.0) * 1e-9 };
    let seen: Vec<[f64; 2]> = solid.points.iter().map(|&p| view.seen(p)).collect();
    let used = || faces.iter().flat_map(|face| face.nodes).map(|node| seen[node]);
    let bound = |k: usize| {
        let of = |start, pick: fn(f64, f64) -> f64| used().map(|p| p[k]).fold(start, pick);
        [of(f64::INFINITY, f64::min), of(f64::NEG_INFINITY, f64::max)]
    };
    let [[left, right], [bottom, top]] = [bound(0), bound(1)];
    let room = f64::from(options.width) - 2.0 * MARGIN - BAR_ROOM;
    let scale = (room / (right - left)).min(1.2 * room / (top - bottom));
    let pixel = |p: [f64; 2]| [MARGIN + (p[0] - left) * scale, TOP + (top - p[1]) * scale];
    let map = ColourMap::Viridis;
    let mut shapes = Vec::new();
    for face in &faces {
        let share = ((face.value - low) / (high - low)).clamp(0.0, 1.0);
        let colour = shaded(map.colour(share), view.light(face.normal));
        let ring = face.nodes.map(|node| pixel(seen[node])).to_vec();
        shapes.push(Shape::Polygons { rings: vec![ring], colour, seam: 0.8 });
        let lines: Vec<Vec<[f64; 2]>> = sides(face.nodes)
            .into_iter()
            .filter(|side| edges.contains_key(side))
            .map(|side| side.map(|node| pixel(seen[node])).to_vec())
            .collect();
        if !lines.is_empty() {
            let colour = Colour([0x22; 3]);
            shapes.push(Shape::Lines { lines, colour, width: 0.6, dash: None });
        }
    }
    let height = (TOP + (top - bottom) * scale + MARGIN).max(TOP + 260.0);
    shapes.extend(bar(options, [low, high], map, height));
    shapes.push(text([MARGIN, 34.0], &options.title, 18.0, Anchor::Start));
    Ok(Picture { width: options.width, height: height.ceil() as u32, shapes })
}

/// The sides of a face, by nodes in ascending order.
fn sides([a, b, c]: [usize; 3]) -> [[usize; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[p, q]| [p.min(q), p.max(q)])
}

/// Faces of one tetrahedron that look at the viewer, and the edges where two of them meet at an
/// angle or nothing meets them.
fn surface(solid: &Solid, view: &View) -> (Vec<Face>, BTreeMap<[usize; 2], ()>) {
    let mut found: BTreeMap<[usize; 3], Option<([usize; 3], usize)>> = BTreeMap::new();
    for (index, &[a, b, c, d]) in solid.tetrahedra.iter().enumerate() {
        for face in [[a, c, b], [a, b, d], [b, c, d], [c, a, d]] {
            let mut key = face;
            key.sort_unstable();
            found.entry(key).and_modify(|first| *first = None).or_insert(Some((face, index)));
        }
    }
    let mut normals: BTreeMap<[usize; 2], Vec<[f64; 3]>> = BTreeMap::new();
    let mut faces = Vec::new();
    for (nodes, index) in found.into_values().flatten() {
        let corners = nodes.map(|node| solid.points[node]);
        let normal = normal(corners);
        sides(nodes).into_iter().for_each(|side| normals.entry(side).or_default().push(normal));
        if dot(normal, view.away) < 0.0 {
            let depth = corners.iter().map(|&p| dot(p, view.away)).sum::<f64>() / 3.0;
            faces.push(Face { nodes, value: solid.values[index], normal, depth });
        }
    }
    let is_flat = |n: &Vec<[f64; 3]>| matches!(n[..], [a, b] if dot(a, b) > 0.95);
    let edges = normals.into_iter().filter(|(_, n)| !is_flat(n)).map(|(side, _)| (side, ()));
    (faces, edges.collect())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Unit normal of a face, outward where its corners run counter-clockwise.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = dot(n, n).sqrt().max(f64::MIN_POSITIVE);
    n.map(|x| x / length)
}

/// A parallel projection.
struct View {
    right: [f64; 3],
    up: [f64; 3],
    away: [f64; 3],
}

impl View {
    fn new([around, above]: [f64; 2]) -> Self {
        let (sa, ca) = around.to_radians().sin_cos();
        let (sh, ch) = above.to_radians().sin_cos();
        View { right: [ca, sa, 0.0], up: [-sa * sh, ca * sh, ch], away: [-sa * ch, ca * ch, -sh] }
    }

    fn seen(&self, p: [f64; 3]) -> [f64; 2] {
        [dot(p, self.right), dot(p, self.up)]
    }

    /// How bright a face is: most where it looks at a lamp above the viewer's left shoulder.
    fn light(&self, normal: [f64; 3]) -> f64 {
        let lamp = [0, 1, 2].map(|k| -0.7 * self.away[k] - 0.35 * self.right[k] + 0.6 * self.up[k]);
        0.55 + 0.45 * (dot(normal, lamp) / dot(lamp, lamp).sqrt()).clamp(0.0, 1.0)
    }
}

fn shaded(Colour(channels): Colour, light: f64) -> Colour {
    Colour(channels.map(|c| (f64::from(c) * light).round() as u8))
}

/// The colour bar with its labels.
fn bar(options: &SolidOptions, [low, high]: [f64; 2], map: ColourMap, height: f64) -> Vec<Shape> {
    let (letters, factor) = prefix(low.abs().max(high.abs()), &options.unit);
    let left = f64::from(options.width) - MARGIN - BAR_ROOM + 30.0;
    let (top, bottom) = (TOP + 20.0, (height - MARGIN).min(TOP + 360.0));
    const STRIPS: usize = 64;
    let at = |share: f64| bottom - share * (bottom - top);
    let mut shapes: Vec<Shape> = (0..STRIPS)
        .map(|k| {
            let [from, to] = [k, k + 1].map(|k| at(k as f64 / STRIPS as f64));
            let ring = vec![[left, from], [left + BAR, from], [left + BAR, to], [left, to]];
            let colour = map.colour((k as f64 + 0.5) / STRIPS as f64);
            Shape::Polygons { rings: vec![ring], colour, seam: 0.5 }
        })
        .collect();
    let ticks = Ticks::new(low / factor, high / factor, 6);
    for (value, label) in ticks.values.iter().zip(&ticks.labels) {
        let y = at((value * factor - low) / (high - low));
        shapes.push(text([left + BAR + 6.0, y + 0.35 * SMALL], label, SMALL, Anchor::Start));
    }
    let unit = format!("{letters}{}", options.unit);
    let name = match unit.is_empty() {
        true => options.quantity.clone(),
        false => format!("{} ({unit})", options.quantity),
    };
    let end = left + BAR + 70.0;
    shapes.push(text([end, top - 12.0], &name, MEDIUM, Anchor::End));
    shapes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_tetrahedra() -> Solid {
        let points =
            vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 1.0]];
        Solid { points, tetrahedra: vec![[0, 1, 2, 3], [1, 2, 3, 4]], values: vec![1.0, 2.0] }
    }

    #[test]
    fn faces_between_tetrahedra_and_those_that_look_away_are_not_seen() {
        let solid = two_tetrahedra();
        let (faces, _) = surface(&solid, &View::new([0.0, 0.0]));
        // from the front: the face y = 0 of the first one; of the second one, what looks back
        let seen: Vec<[usize; 3]> = faces
            .iter()
            .map(|face| {
                let mut nodes = face.nodes;
                nodes.sort_unstable();
                nodes
            })
            .collect();
        assert!(seen.contains(&[0, 1, 3]), "{seen:?}");
        assert!(!seen.contains(&[1, 2, 3]) && !seen.contains(&[0, 2, 3]), "{seen:?}");
    }

    #[test]
    fn what_is_in_front_is_drawn_last() {
        let mut shown = two_tetrahedra();
        // the same once more, behind
        let count = shown.points.len();
        let behind: Vec<[f64; 3]> = shown.points.iter().map(|p| [p[0], p[1] + 5.0, p[2]]).collect();
        shown.points.extend(behind);
        shown.tetrahedra.extend([[0, 1, 2, 3].map(|n| n + count), [1, 2, 3, 4].map(|n| n + count)]);
        shown.values.extend([3.0, 4.0]);
        let options = SolidOptions {
            title: "two".to_owned(),
            quantity: "number".to_owned(),
            unit: String::new(),
            range: None,
            from_deg: [20.0, 20.0],
            width: 600,
        };
        let picture = solid(&shown, &options).expect("a picture");
        assert!(picture.to_svg().contains("<svg"));
        let (mut faces, _) = surface(&shown, &View::new(options.from_deg));
        faces.sort_by(|a, b| b.depth.total_cmp(&a.depth));
        assert!(faces.first().is_some_and(|face| face.value > 2.0));
        assert!(faces.last().is_some_and(|face| face.value < 3.0));
        shown.values.pop();
        assert!(solid(&shown, &options).is_err());
    }
}
