//! Refinement of triangles into 4 or 6 (spec `y2d3d.md` D.2).

use super::{CapacityError, Mesh};
use crate::{TOLERANCE, scene::JointKind};

/// Mid nodes made in a pass, kept at the higher node of their edge.
pub(super) struct MidNodes {
    at: Vec<Vec<usize>>,
}

impl MidNodes {
    pub(super) fn new(nodes: usize) -> Self {
        Self { at: vec![Vec::new(); nodes] }
    }

    /// The mid node of edge a–b, found by its position (newest first) or made.
    /// A node found a second time lies inside the body.
    fn of(&mut self, mesh: &mut Mesh<'_>, a: usize, b: usize) -> usize {
        let (high, low) = (a.max(b), a.min(b));
        let nodes = &mut *mesh.nodes;
        if self.at.len() <= high {
            self.at.resize_with(high + 1, Vec::new);
        }
        let middle = (nodes.current[high] + nodes.current[low]) / 2.0;
        let found = self.at[high].iter().rev().copied().find(|&n| {
            let d = nodes.current[n] - middle;
            d.x.abs() + d.y.abs() < TOLERANCE
        });
        if let Some(node) = found {
            nodes.boundary_flag[node] = 0;
            return node;
        }
        nodes.current.push(middle);
        nodes.initial.push((nodes.initial[high] + nodes.initial[low]) / 2.0);
        nodes.velocity.push((nodes.velocity[high] + nodes.velocity[low]) / 2.0);
        nodes.set.push(nodes.set[high].min(nodes.set[low]));
        nodes.boundary_flag.push(1);
        let node = nodes.len() - 1;
        self.at[high].push(node);
        node
    }

    fn of_triangle(&mut self, mesh: &mut Mesh<'_>, v: [usize; 3]) -> [usize; 3] {
        std::array::from_fn(|i| self.of(mesh, v[i], v[(i + 1) % 3]))
    }
}

/// Each triangle into 4: the corner triangles are appended, the inner one
/// replaces the original.
pub(super) fn into_four(
    mesh: &mut Mesh<'_>,
    triangles: &[usize],
    first_material: Option<usize>,
    mid_nodes: &mut MidNodes,
) -> Result<(), CapacityError> {
    for &element in triangles {
        let v = mesh.elements.corners::<3>(element);
        let m = mid_nodes.of_triangle(mesh, v);
        for corner in [[v[0], m[0], m[2]], [v[1], m[1], m[0]], [v[2], m[2], m[1]]] {
            append_triangle(mesh, element, corner);
        }
        mesh.elements.set_corners(element, m);
        finish_triangle(mesh, v, m, first_material)?;
    }
    Ok(())
}

/// Each triangle into 6 around its centre.
pub(super) fn into_six(
    mesh: &mut Mesh<'_>,
    triangles: &[usize],
    first_material: Option<usize>,
    mid_nodes: &mut MidNodes,
) -> Result<(), CapacityError> {
    for &element in triangles {
        let v = mesh.elements.corners::<3>(element);
        let m = mid_nodes.of_triangle(mesh, v);
        let c = push_centre(mesh, v);
        for corners in
            [[m[0], v[1], c], [v[1], m[1], c], [m[1], v[2], c], [v[2], m[2], c], [m[2], v[0], c]]
        {
            append_triangle(mesh, element, corners);
        }
        mesh.elements.set_corners(element, [v[0], m[0], c]);
        finish_triangle(mesh, v, m, first_material)?;
    }
    Ok(())
}

fn push_centre(mesh: &mut Mesh<'_>, v: [usize; 3]) -> usize {
    let nodes = &mut *mesh.nodes;
    for list in [&mut nodes.initial, &mut nodes.current, &mut nodes.velocity] {
        list.push((list[v[0]] + list[v[1]] + list[v[2]]) / 3.0);
    }
    nodes.set.push(v.map(|n| nodes.set[n]).into_iter().min().unwrap_or(-1));
    nodes.boundary_flag.push(0);
    nodes.len() - 1
}

fn append_triangle(mesh: &mut Mesh<'_>, original: usize, corners: [usize; 3]) {
    let property = mesh.elements.property[original];
    let element = mesh.elements.push([-1; 6], property, JointKind::NoJoint);
    mesh.elements.set_corners(element, corners);
    let damage_row = usize::try_from(property)
        .ok()
        .and_then(|p| mesh.materials.get(p))
        .and_then(|m| usize::try_from(m.damage_row).ok());
    if let Some(row) = damage_row.and_then(|row| mesh.elements.state.get_mut(row)) {
        row[element] = row[original];
    }
}

fn finish_triangle(
    mesh: &mut Mesh<'_>,
    corners: [usize; 3],
    mid_nodes: [usize; 3],
    first_material: Option<usize>,
) -> Result<(), CapacityError> {
    let mark_all =
        first_material.and_then(|m| mesh.materials.get(m)).is_some_and(|m| m.boundary_marking < 1);
    if mark_all {
        for node in corners.into_iter().chain(mid_nodes) {
            mesh.nodes.boundary_flag[node] = 1;
        }
    }
    mesh.check_capacity()
}
