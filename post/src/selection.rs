//! Nodes chosen by what they are or where they were at the start.

use std::str::FromStr;

use crate::error::PostError;

/// Nodes of a scene, chosen by one rule. Places are those at the start of the run.
///
/// ```
/// use ypsilon_post::selection::Selection;
/// assert_eq!("set:2".parse::<Selection>()?, Selection::Set(2));
/// assert_eq!(
///     "box:0:1.5,:0.1".parse::<Selection>()?,
///     Selection::Box([[0.0, 1.5], [f64::NEG_INFINITY, 0.1]])
/// );
/// # Ok::<(), ypsilon_post::PostError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Selection {
    /// All nodes: `all`.
    All,
    /// Nodes by number, from 0: `node:17` or `nodes:3,5,9`.
    Nodes(Vec<usize>),
    /// Nodes of a node set, as in I1NOPR: `set:2`.
    Set(i32),
    /// Nodes within a box: `box:X0:X1,Y0:Y1`; a bound (or both) left out is open. The bounds belong to it.
    Box([[f64; 2]; 2]),
    /// Nodes on a line within a thousandth of its length: `line:X0,Y0,X1,Y1`.
    Line([[f64; 2]; 2]),
    /// Nodes of the triangles of a property set, from 0: `material:1`.
    Material(i32),
    /// Nodes of the triangles of a body: `body:0`.
    Body(i32),
}

/// What a selection is made among.
#[derive(Debug, Clone, Copy)]
pub struct Mesh<'a> {
    /// Places of the nodes at the start, m.
    pub initial: &'a [[f64; 2]],
    /// Node set of each node, where known.
    pub node_set: Option<&'a [i32]>,
    /// Corners of the triangles.
    pub triangles: &'a [[u32; 3]],
    /// Property of each triangle, from 0.
    pub property: &'a [i32],
    /// Body of each triangle, where known.
    pub body: Option<&'a [i32]>,
}

/// How far from a line its nodes may lie, relative to its length.
const LINE_TOLERANCE: f64 = 1e-3;

/// The forms, for messages.
const FORMS: &str = "expected all, node:N, nodes:N,N,..., set:N, box:X0:X1,Y0:Y1, \
                     line:X0,Y0,X1,Y1, material:N or body:N";

impl FromStr for Selection {
    type Err = PostError;

    fn from_str(words: &str) -> Result<Self, PostError> {
        Self::parse(words.trim()).ok_or_else(|| PostError::words("the selection", words, FORMS))
    }
}

impl Selection {
    fn parse(words: &str) -> Option<Self> {
        if words == "all" {
            return Some(Self::All);
        }
        let (kind, rest) = words.split_once(':')?;
        match kind {
            "node" | "nodes" => {
                let numbers = rest.split(',').map(|n| n.trim().parse().ok());
                numbers.collect::<Option<_>>().map(Self::Nodes)
            }
            "set" => rest.trim().parse().ok().map(Self::Set),
            "material" => rest.trim().parse().ok().map(Self::Material),
            "body" => rest.trim().parse().ok().map(Self::Body),
            "box" => {
                let (x, y) = rest.split_once(',')?;
                Some(Self::Box([range(x)?, range(y)?]))
            }
            "line" => {
                let numbers: Vec<f64> =
                    rest.split(',').map(|n| finite(n.trim())).collect::<Option<_>>()?;
                match numbers[..] {
                    [x0, y0, x1, y1] => Some(Self::Line([[x0, y0], [x1, y1]])),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The nodes, ascending. Nodes of no triangle (joint insertion leaves the deck's own nodes
    /// behind, at rest) belong to no selection but that of their numbers.
    ///
    /// # Errors
    /// If there are none, or if the mesh does not know what is asked for.
    pub fn nodes(&self, mesh: &Mesh<'_>) -> Result<Vec<usize>, PostError> {
        let count = mesh.initial.len();
        let mut used = vec![false; count];
        for &node in mesh.triangles.iter().flatten() {
            if let Some(used) = used.get_mut(node as usize) {
                *used = true;
            }
        }
        let where_true = |is_chosen: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..count).filter(|&n| used[n] && is_chosen(n)).collect()
        };
        let at = |n: usize| mesh.initial.get(n).copied().unwrap_or([f64::NAN; 2]);
        let nodes = match self {
            Self::All => where_true(&|_| true),
            Self::Nodes(numbers) => {
                if let Some(&wrong) = numbers.iter().find(|&&n| n >= count) {
                    return Err(PostError::Nothing(format!(
                        "there is no node {wrong}; nodes run from 0 to {}",
                        count.saturating_sub(1)
                    )));
                }
                let mut numbers = numbers.clone();
                numbers.sort_unstable();
                numbers.dedup();
                numbers
            }
            Self::Set(set) => {
                let sets = mesh.node_set.ok_or(PostError::MissingArray {
                    array: "node sets",
                    wanted: format!("the selection set:{set}"),
                    remedy: "VTU files of Ypsilon have them, or choose a box",
                })?;
                where_true(&|n| sets.get(n) == Some(set))
            }
            Self::Box([x, y]) => where_true(&|n| {
                let p = at(n);
                x[0] <= p[0] && p[0] <= x[1] && y[0] <= p[1] && p[1] <= y[1]
            }),
            Self::Line([a, b]) => where_true(&|n| is_near_line(at(n), *a, *b)),
            Self::Material(material) => of_triangles(mesh, Some(mesh.property), *material),
            Self::Body(body) => {
                if mesh.body.is_none() {
                    return Err(PostError::MissingArray {
                        array: "bodies",
                        wanted: format!("the selection body:{body}"),
                        remedy: "VTU files of Ypsilon have them, or choose a box",
                    });
                }
                of_triangles(mesh, mesh.body, *body)
            }
        };
        if nodes.is_empty() {
            return Err(PostError::Nothing(format!(
                "the selection {self} holds no node; places are those at the start of the run"
            )));
        }
        Ok(nodes)
    }
}

impl std::fmt::Display for Selection {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let bound = |b: f64| if b.is_finite() { b.to_string() } else { String::new() };
        match self {
            Self::All => write!(f, "all"),
            Self::Nodes(nodes) => {
                let nodes: Vec<String> = nodes.iter().map(usize::to_string).collect();
                write!(f, "nodes:{}", nodes.join(","))
            }
            Self::Set(set) => write!(f, "set:{set}"),
            Self::Box([x, y]) => {
                write!(f, "box:{}:{},{}:{}", bound(x[0]), bound(x[1]), bound(y[0]), bound(y[1]))
            }
            Self::Line([a, b]) => write!(f, "line:{},{},{},{}", a[0], a[1], b[0], b[1]),
            Self::Material(material) => write!(f, "material:{material}"),
            Self::Body(body) => write!(f, "body:{body}"),
        }
    }
}

fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|x: &f64| x.is_finite())
}

fn range(words: &str) -> Option<[f64; 2]> {
    let words = if words.trim().is_empty() { ":" } else { words };
    let (low, high) = words.split_once(':')?;
    let bound = |word: &str, open: f64| match word.trim() {
        "" => Some(open),
        word => finite(word),
    };
    Some([bound(low, f64::NEG_INFINITY)?, bound(high, f64::INFINITY)?])
}

fn is_near_line(p: [f64; 2], a: [f64; 2], b: [f64; 2]) -> bool {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let length = along[0].hypot(along[1]);
    let tolerance = LINE_TOLERANCE * length;
    let s = (along[0] * to[0] + along[1] * to[1]) / length;
    let off = (along[0] * to[1] - along[1] * to[0]) / length;
    off.abs() <= tolerance && -tolerance <= s && s <= length + tolerance
}

fn of_triangles(mesh: &Mesh<'_>, labels: Option<&[i32]>, label: i32) -> Vec<usize> {
    let labels = labels.unwrap_or(&[]);
    let chosen = mesh.triangles.iter().zip(labels).filter(|(_, l)| **l == label);
    let mut nodes: Vec<usize> =
        chosen.flat_map(|(corners, _)| corners.map(|n| n as usize)).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: Mesh<'_> = Mesh {
        initial: &[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        node_set: Some(&[1, 1, 0, 2]),
        triangles: &[[0, 1, 2], [0, 2, 3]],
        property: &[0, 1],
        body: None,
    };

    fn nodes(words: &str) -> Vec<usize> {
        words.parse::<Selection>().expect("a selection").nodes(&SQUARE).expect("nodes")
    }

    #[test]
    fn every_form_selects() {
        assert_eq!(nodes("all"), [0, 1, 2, 3]);
        assert_eq!(nodes("nodes:3,1,3"), [1, 3]);
        assert_eq!(nodes("set:1"), [0, 1]);
        assert_eq!(nodes("box:0.5:,:"), [1, 2]);
        assert_eq!(nodes("box:,0.5:"), [2, 3]);
        assert_eq!(nodes("line:0,1,1,1"), [2, 3]);
        assert_eq!(nodes("material:1"), [0, 2, 3]);
    }

    #[test]
    fn what_is_not_there_is_told() {
        let fault = |words: &str| match words.parse::<Selection>() {
            Ok(selection) => selection.nodes(&SQUARE).expect_err("a fault").to_string(),
            Err(fault) => fault.to_string(),
        };
        assert!(fault("node:4").contains("nodes run from 0 to 3"));
        assert!(fault("box:5:6,:").contains("holds no node"));
        assert!(fault("body:0").contains("no bodies"));
        assert!(fault("circle:1").contains("expected all, node:N"));
        assert!(fault("line:0,0,0,0").contains("holds no node"));
    }
}
