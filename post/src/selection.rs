//! Nodes chosen by what they are or where they were at the start.

use std::str::FromStr;

use crate::error::PostError;
use crate::point::{Point, finite, in_words};
use crate::vectors::{area_between, length, minus};

/// Nodes of a scene, chosen by one rule. Places are those at the start of the run.
///
/// ```
/// use ypsilon_post::selection::Selection;
/// assert_eq!("set:2".parse::<Selection>()?, Selection::Set(2));
/// assert_eq!(
///     "box:0:1.5,:0.1".parse::<Selection>()?,
///     Selection::Box(vec![[0.0, 1.5], [f64::NEG_INFINITY, 0.1]])
/// );
/// let in_space = "box:0:1.5,:0.1,2:3".parse::<Selection>()?;
/// assert!(matches!(in_space, Selection::Box(ranges) if ranges.len() == 3));
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
    /// Nodes within a box: `box:X0:X1,Y0:Y1`, in space `box:X0:X1,Y0:Y1,Z0:Z1`; a bound (or both)
    /// left out is open. The bounds belong to it.
    Box(Vec<[f64; 2]>),
    /// Nodes on a line within a thousandth of its length: `line:X0,Y0,X1,Y1`, in space
    /// `line:X0,Y0,Z0,X1,Y1,Z1`.
    Line([Point; 2]),
    /// Nodes of the elements of a property set, from 0: `material:1`.
    Material(i32),
    /// Nodes of the elements of a body: `body:0`.
    Body(i32),
}

/// What a selection is made among: triangles in the plane, or tetrahedra in space.
#[derive(Debug, Clone, Copy)]
pub struct Mesh<'a, const D: usize = 2, const C: usize = 3> {
    /// Places of the nodes at the start, m.
    pub initial: &'a [[f64; D]],
    /// Node set of each node, where known.
    pub node_set: Option<&'a [i32]>,
    /// Corners of the elements.
    pub elements: &'a [[u32; C]],
    /// Nodes on the edges of the elements that have them; empty where none has.
    pub edge_nodes: &'a [Option<[u32; 6]>],
    /// Property of each element, from 0.
    pub property: &'a [i32],
    /// Body of each element, where known.
    pub body: Option<&'a [i32]>,
}

impl<const D: usize, const C: usize> Mesh<'_, D, C> {
    /// Nodes of an element: its corners, then those on its edges.
    pub fn nodes_of(&self, element: usize) -> impl Iterator<Item = usize> {
        let corners = self.elements.get(element).into_iter().flatten();
        let on_edges = self.edge_nodes.get(element).into_iter().flatten().flatten();
        corners.chain(on_edges).map(|&node| node as usize)
    }

    /// Whether each node is one of an element.
    #[must_use]
    pub fn used(&self) -> Vec<bool> {
        let mut used = vec![false; self.initial.len()];
        for node in (0..self.elements.len()).flat_map(|element| self.nodes_of(element)) {
            if let Some(used) = used.get_mut(node) {
                *used = true;
            }
        }
        used
    }
}

/// How far from a line its nodes may lie, relative to its length.
const LINE_TOLERANCE: f64 = 1e-3;

/// The forms, for messages.
const FORMS: &str = "expected all, node:N, nodes:N,N,..., set:N, box:X0:X1,Y0:Y1, \
                     line:X0,Y0,X1,Y1, material:N or body:N; in space box:X0:X1,Y0:Y1,Z0:Z1 \
                     and line:X0,Y0,Z0,X1,Y1,Z1";

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
                let ranges = rest.split(',').map(range).collect::<Option<Vec<_>>>()?;
                (2..=3).contains(&ranges.len()).then_some(Self::Box(ranges))
            }
            "line" => {
                let numbers: Vec<f64> =
                    rest.split(',').map(|n| finite(n.trim())).collect::<Option<_>>()?;
                let (from, to) = numbers.split_at(numbers.len() / 2);
                Some(Self::Line([Point::of(from)?, Point::of(to)?]))
                    .filter(|_| from.len() == to.len())
            }
            _ => None,
        }
    }

    /// The nodes, ascending. Nodes of no element (joint insertion leaves the deck's own nodes
    /// behind, at rest) belong to no selection but that of their numbers.
    ///
    /// # Errors
    /// If there are none, if the mesh does not know what is asked for, or if the selection is one
    /// of the plane and the mesh in space, or the other way round.
    pub fn nodes<const D: usize, const C: usize>(
        &self,
        mesh: &Mesh<'_, D, C>,
    ) -> Result<Vec<usize>, PostError> {
        self.check(D)?;
        let count = mesh.initial.len();
        let used = mesh.used();
        let where_true = |is_chosen: &dyn Fn(usize) -> bool| -> Vec<usize> {
            (0..count).filter(|&n| used[n] && is_chosen(n)).collect()
        };
        let at = |n: usize| mesh.initial.get(n).copied().unwrap_or([f64::NAN; D]);
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
            Self::Box(ranges) => where_true(&|n| {
                at(n).iter().zip(ranges).all(|(x, [low, high])| low <= x && x <= high)
            }),
            Self::Line([a, b]) => {
                let (a, b) = (a.within()?, b.within()?);
                where_true(&|n| is_near_line(at(n), a, b))
            }
            Self::Material(material) => of_elements(mesh, Some(mesh.property), *material),
            Self::Body(body) => {
                if mesh.body.is_none() {
                    return Err(PostError::MissingArray {
                        array: "bodies",
                        wanted: format!("the selection body:{body}"),
                        remedy: "VTU files of Ypsilon have them, or choose a box",
                    });
                }
                of_elements(mesh, mesh.body, *body)
            }
        };
        if nodes.is_empty() {
            return Err(PostError::Nothing(format!(
                "the selection {self} holds no node; places are those at the start of the run"
            )));
        }
        Ok(nodes)
    }

    /// Checks that it is one of results of so many dimensions.
    ///
    /// # Errors
    /// If it is not.
    pub fn check(&self, dimension: usize) -> Result<(), PostError> {
        let (own, forms) = match self {
            Self::Box(ranges) => (ranges.len(), ["box:X0:X1,Y0:Y1", "box:X0:X1,Y0:Y1,Z0:Z1"]),
            Self::Line([a, _]) => {
                (a.coordinates().len(), ["line:X0,Y0,X1,Y1", "line:X0,Y0,Z0,X1,Y1,Z1"])
            }
            _ => return Ok(()),
        };
        if own == dimension {
            return Ok(());
        }
        let (bodies, form) = (in_words(dimension), forms[usize::from(dimension > 2)]);
        Err(PostError::Nothing(format!(
            "the selection {self} does not fit results of bodies {bodies}; expected {form}"
        )))
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
            Self::Box(ranges) => {
                let range = |r: &[f64; 2]| format!("{}:{}", bound(r[0]), bound(r[1]));
                write!(f, "box:{}", ranges.iter().map(range).collect::<Vec<_>>().join(","))
            }
            Self::Line([a, b]) => write!(f, "line:{a},{b}"),
            Self::Material(material) => write!(f, "material:{material}"),
            Self::Body(body) => write!(f, "body:{body}"),
        }
    }
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

fn is_near_line<const D: usize>(p: [f64; D], a: [f64; D], b: [f64; D]) -> bool {
    let (along, to) = (minus(b, a), minus(p, a));
    let whole = length(along);
    let tolerance = LINE_TOLERANCE * whole;
    let s = along.iter().zip(&to).map(|(a, t)| a * t).sum::<f64>() / whole;
    let off = area_between(along, to) / whole;
    off <= tolerance && -tolerance <= s && s <= whole + tolerance
}

fn of_elements<const D: usize, const C: usize>(
    mesh: &Mesh<'_, D, C>,
    labels: Option<&[i32]>,
    label: i32,
) -> Vec<usize> {
    let labels = labels.unwrap_or(&[]);
    let chosen = (0..mesh.elements.len()).zip(labels).filter(|(_, l)| **l == label);
    let mut nodes: Vec<usize> = chosen.flat_map(|(element, _)| mesh.nodes_of(element)).collect();
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
        elements: &[[0, 1, 2], [0, 2, 3]],
        edge_nodes: &[],
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

    /// A tetrahedron with nodes on its edges, and one without.
    const SOLID: Mesh<'_, 3, 4> = Mesh {
        initial: &[
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
            [0.5, 0.0, 0.0],
            [0.5, 0.5, 0.0],
            [0.0, 0.5, 0.0],
            [0.0, 0.0, 0.5],
            [0.5, 0.0, 0.5],
            [0.0, 0.5, 0.5],
            [0.0, 0.0, -1.0],
            [0.0, 0.0, 0.0],
        ],
        node_set: None,
        elements: &[[0, 1, 2, 3], [0, 2, 1, 10]],
        edge_nodes: &[Some([4, 5, 6, 7, 8, 9]), None],
        property: &[0, 1],
        body: Some(&[0, 0]),
    };

    #[test]
    fn every_form_selects_in_space() {
        let nodes = |words: &str| {
            words.parse::<Selection>().expect("a selection").nodes(&SOLID).expect("nodes")
        };
        assert_eq!(nodes("all"), [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
        assert_eq!(nodes("box:,:0.1,0.5:1"), [3, 7, 8]);
        assert_eq!(nodes("box:,,:-0.5"), [10]);
        assert_eq!(nodes("line:0,0,1,1,0,0"), [1, 3, 8]);
        assert_eq!(nodes("material:1"), [0, 1, 2, 10]);
        assert_eq!(nodes("body:0").len(), 11);
        assert_eq!(nodes("node:11"), [11]);
    }

    #[test]
    fn selections_of_other_dimensions_are_told() {
        let fault = |selection: &str, in_space: bool| {
            let selection: Selection = selection.parse().expect("a selection");
            let found = if in_space { selection.nodes(&SOLID) } else { selection.nodes(&SQUARE) };
            found.expect_err("a fault").to_string()
        };
        assert_eq!(
            fault("box:0:1,:", true),
            "the selection box:0:1,: does not fit results of bodies in space; \
             expected box:X0:X1,Y0:Y1,Z0:Z1"
        );
        assert!(fault("line:0,0,1,1", true).ends_with("expected line:X0,Y0,Z0,X1,Y1,Z1"));
        assert!(fault("box:,,0:1", false).ends_with("in the plane; expected box:X0:X1,Y0:Y1"));
        assert!(fault("line:0,0,0,1,1,1", false).ends_with("expected line:X0,Y0,X1,Y1"));
        for words in ["box:0:1", "box:,,,", "line:0,0,0,1,1", "line:0,0"] {
            assert!(words.parse::<Selection>().is_err(), "{words}");
        }
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
