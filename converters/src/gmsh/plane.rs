//! What a deck needs of a mesh: triangles in the plane, counter-clockwise, with sets.

use std::collections::{BTreeMap, BTreeSet};

use super::error::GmshError;
use super::mesh::{ElementKind, Mesh};

/// A physical group: dimension and tag.
pub(super) type Group = (i64, i64);

/// A mesh of triangles.
#[derive(Debug, Clone)]
pub(super) struct PlaneMesh {
    /// Coordinates of the nodes that triangles use.
    pub(super) nodes: Vec<[f64; 2]>,
    /// Nodes of the triangles, counter-clockwise.
    pub(super) triangles: Vec<[usize; 3]>,
    /// Element set of each triangle.
    pub(super) element_set: Vec<usize>,
    /// The physical surface of each element set; `None`: triangles of no group.
    pub(super) element_sets: Vec<Option<i64>>,
    /// Node set of each node; 0 is that of nodes of no group.
    pub(super) node_set: Vec<usize>,
    /// The physical curves and points of the node sets from 1 on.
    pub(super) node_sets: Vec<Group>,
    /// Whether each node is an end of an edge with one triangle.
    pub(super) on_boundary: Vec<bool>,
    /// Pairs of different element sets with a common edge, the smaller one first.
    pub(super) neighbours: BTreeSet<(usize, usize)>,
    /// What got lost.
    pub(super) warnings: Vec<String>,
}

/// A triangle or a quadrangle with node indices instead of numbers.
struct Face {
    tag: i64,
    corners: Vec<usize>,
    group: Option<i64>,
}

pub(super) fn plane_mesh(mesh: &Mesh) -> Result<PlaneMesh, GmshError> {
    let mut warnings = mesh.notes.clone();
    let indices = node_indices(mesh)?;
    let faces = faces(mesh, &indices, &mut warnings)?;
    check_plane(mesh, &faces)?;
    let mut element_sets: Vec<Option<i64>> = faces.iter().map(|face| face.group).collect();
    // `None` sorts first but is to be the last set.
    element_sets.sort_by_key(|group| (group.is_none(), *group));
    element_sets.dedup();
    let set_of: BTreeMap<Option<i64>, usize> =
        element_sets.iter().enumerate().map(|(set, &group)| (group, set)).collect();
    let (mut triangles, mut element_set) = (Vec::new(), Vec::new());
    for face in &faces {
        let set = set_of.get(&face.group).copied().unwrap_or(0);
        for corners in pieces(mesh, face)? {
            triangles.push(corners);
            element_set.push(set);
        }
    }
    let used: BTreeSet<usize> = triangles.iter().flatten().copied().collect();
    let new_index: BTreeMap<usize, usize> =
        used.iter().enumerate().map(|(new, &old)| (old, new)).collect();
    for corner in triangles.iter_mut().flatten() {
        *corner = new_index.get(corner).copied().unwrap_or(0);
    }
    let point = |&old: &usize| mesh.nodes.get(old).map(|node| [node.position[0], node.position[1]]);
    let nodes: Vec<[f64; 2]> = used.iter().filter_map(point).collect();
    if nodes.len() < mesh.nodes.len() {
        let unused = mesh.nodes.len() - nodes.len();
        warnings.push(format!("nodes that belong to no triangle are left out: {unused} of them"));
    }
    let (node_set, node_sets) = node_sets(mesh, &indices, &new_index, nodes.len(), &mut warnings)?;
    let (on_boundary, neighbours) = edges(&triangles, &element_set, nodes.len());
    Ok(PlaneMesh {
        nodes,
        triangles,
        element_set,
        element_sets,
        node_set,
        node_sets,
        on_boundary,
        neighbours,
        warnings,
    })
}

fn node_indices(mesh: &Mesh) -> Result<BTreeMap<i64, usize>, GmshError> {
    let mut indices = BTreeMap::new();
    for (index, node) in mesh.nodes.iter().enumerate() {
        if indices.insert(node.tag, index).is_some() {
            return Err(GmshError::NodeTwice(node.tag));
        }
    }
    Ok(indices)
}

fn resolved(
    indices: &BTreeMap<i64, usize>,
    element: i64,
    nodes: &[i64],
) -> Result<Vec<usize>, GmshError> {
    let index =
        |&node: &i64| indices.get(&node).copied().ok_or(GmshError::NoSuchNode { element, node });
    nodes.iter().map(index).collect()
}

/// The triangles and quadrangles; of several that are the same one, that of the greatest group.
fn faces(
    mesh: &Mesh,
    indices: &BTreeMap<i64, usize>,
    warnings: &mut Vec<String>,
) -> Result<Vec<Face>, GmshError> {
    let mut faces: Vec<Face> = Vec::new();
    let mut known: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    let mut repeated = 0;
    for element in &mesh.elements {
        if !matches!(element.kind, ElementKind::Triangle | ElementKind::Quadrangle) {
            continue;
        }
        let corners = resolved(indices, element.tag, &element.nodes)?;
        let mut key = corners.clone();
        key.sort_unstable();
        match known.get(&key).and_then(|&face| faces.get_mut(face)) {
            Some(face) => {
                face.group = face.group.max(element.group);
                repeated += 1;
            }
            None => {
                known.insert(key, faces.len());
                faces.push(Face { tag: element.tag, corners, group: element.group });
            }
        }
    }
    if repeated > 0 {
        warnings.push(format!(
            "elements in several physical surfaces are in that with the greatest tag: {repeated} \
             of them"
        ));
    }
    if faces.is_empty() { Err(GmshError::NoTriangles) } else { Ok(faces) }
}

fn check_plane(mesh: &Mesh, faces: &[Face]) -> Result<(), GmshError> {
    let mut used = faces.iter().flat_map(|face| &face.corners).filter_map(|&i| mesh.nodes.get(i));
    let Some(first) = used.next() else { return Ok(()) };
    let size = mesh.nodes.iter().flat_map(|n| n.position).fold(0.0, |a: f64, x| a.max(x.abs()));
    match used.find(|node| (node.position[2] - first.position[2]).abs() > 1e-9 * size) {
        None => Ok(()),
        Some(node) => Err(GmshError::NotPlane {
            node: node.tag,
            z: node.position[2].to_string(),
            plane: first.position[2].to_string(),
        }),
    }
}

/// Twice the area, positive for counter-clockwise corners.
fn double_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

/// The triangles of a face, counter-clockwise. A quadrangle is cut along the diagonal that
/// leaves the better triangles.
fn pieces(mesh: &Mesh, face: &Face) -> Result<Vec<[usize; 3]>, GmshError> {
    let at = |corner: usize| {
        mesh.nodes.get(corner).map_or([0.0; 2], |node| [node.position[0], node.position[1]])
    };
    let area = |corners: &[usize; 3]| double_area(corners.map(at));
    let pieces = match face.corners[..] {
        [a, b, c] => vec![[a, b, c]],
        [a, b, c, d] => {
            let cuts = [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]];
            let sign = (area(&cuts[0][0]) + area(&cuts[0][1])).signum();
            let worst = |cut: &[[usize; 3]; 2]| (sign * area(&cut[0])).min(sign * area(&cut[1]));
            let [first, second] = cuts;
            if worst(&second) > worst(&first) { second.to_vec() } else { first.to_vec() }
        }
        _ => Vec::new(),
    };
    let turned = |corners: [usize; 3]| {
        let [a, b, c] = corners;
        match area(&corners) {
            positive if positive > 0.0 && positive.is_finite() => Ok([a, b, c]),
            negative if negative < 0.0 && negative.is_finite() => Ok([a, c, b]),
            _ => Err(GmshError::NoArea(face.tag)),
        }
    };
    pieces.into_iter().map(turned).collect()
}

/// The node sets: 0 for nodes of no group, then curves and points in order of their tags.
fn node_sets(
    mesh: &Mesh,
    indices: &BTreeMap<i64, usize>,
    new_index: &BTreeMap<usize, usize>,
    nodes: usize,
    warnings: &mut Vec<String>,
) -> Result<(Vec<usize>, Vec<Group>), GmshError> {
    let rank = |&(dimension, tag): &Group| (-dimension, tag);
    let mut members: BTreeMap<(i64, i64), BTreeSet<usize>> = BTreeMap::new();
    for element in &mesh.elements {
        let (ElementKind::Line | ElementKind::Point, Some(tag)) = (element.kind, element.group)
        else {
            continue;
        };
        let set = members.entry(rank(&(element.kind.dimension(), tag))).or_default();
        for node in resolved(indices, element.tag, &element.nodes)? {
            set.extend(new_index.get(&node));
        }
    }
    let mut node_set = vec![0; nodes];
    let (mut groups, mut shared) = (Vec::new(), 0);
    for (index, ((negative, tag), set)) in members.into_iter().enumerate() {
        groups.push((-negative, tag));
        for node in set {
            if let Some(slot) = node_set.get_mut(node) {
                shared += usize::from(*slot != 0);
                *slot = index + 1;
            }
        }
    }
    if shared > 0 {
        warnings.push(format!(
            "nodes in several physical groups are in the set listed last: {shared} of them"
        ));
    }
    Ok((node_set, groups))
}

/// Which nodes are ends of edges with one triangle, and which sets have common edges.
fn edges(
    triangles: &[[usize; 3]],
    element_set: &[usize],
    nodes: usize,
) -> (Vec<bool>, BTreeSet<(usize, usize)>) {
    let mut first: BTreeMap<(usize, usize), (usize, bool)> = BTreeMap::new();
    let mut neighbours = BTreeSet::new();
    for (&[a, b, c], &set) in triangles.iter().zip(element_set) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let edge = (from.min(to), from.max(to));
            match first.get_mut(&edge) {
                None => {
                    first.insert(edge, (set, true));
                }
                Some((other, alone)) => {
                    *alone = false;
                    if *other != set {
                        neighbours.insert((set.min(*other), set.max(*other)));
                    }
                }
            }
        }
    }
    let mut on_boundary = vec![false; nodes];
    for (&(a, b), _) in first.iter().filter(|(_, (_, alone))| *alone) {
        for node in [a, b] {
            if let Some(flag) = on_boundary.get_mut(node) {
                *flag = true;
            }
        }
    }
    (on_boundary, neighbours)
}
