//! Triangles made from blocks.

use super::{
    MeshingError,
    pattern::{Pattern, Point, area, line, middle},
    properties::check_elements,
};
use std::collections::BTreeMap;

/// A triangle of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Triangle {
    /// Its nodes, counter-clockwise.
    pub nodes: [usize; 3],
    /// The block that it belongs to.
    pub block: usize,
    /// What it is made of: an index into the model's materials.
    pub material: usize,
}

/// Nodes and triangles; neighbours share nodes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Places of the nodes \[m\].
    pub nodes: Vec<Point>,
    /// The triangles.
    pub triangles: Vec<Triangle>,
    /// Number of blocks.
    pub blocks: usize,
}

impl Mesh {
    /// Places of a triangle's corners.
    #[must_use]
    pub fn corners(&self, triangle: &Triangle) -> [Point; 3] {
        triangle.nodes.map(|node| self.nodes[node])
    }

    /// Area of a triangle, positive if it runs counter-clockwise \[m²\].
    #[must_use]
    pub fn area(&self, triangle: &Triangle) -> f64 {
        area(&self.corners(triangle))
    }

    /// The shortest height of a triangle \[m\]: twice its area by its longest edge.
    #[must_use]
    pub fn height(&self, triangle: &Triangle) -> f64 {
        let c = self.corners(triangle);
        let longest = (0..3)
            .map(|k| (c[k][0] - c[(k + 1) % 3][0]).hypot(c[k][1] - c[(k + 1) % 3][1]))
            .fold(0.0, f64::max);
        2.0 * self.area(triangle) / longest
    }

    /// Area of all triangles \[m²\].
    #[must_use]
    pub fn total_area(&self) -> f64 {
        self.triangles.iter().map(|t| self.area(t)).sum()
    }

    /// Adds a body of its own: a rectangle of `columns` by `rows` cells with two triangles each,
    /// whose diagonals alternate. It is one block.
    ///
    /// # Errors
    /// If the mesh would become too large.
    pub(super) fn rectangle(
        &mut self,
        [from, to]: [Point; 2],
        [columns, rows]: [usize; 2],
        material: usize,
    ) -> Result<std::ops::Range<usize>, MeshingError> {
        check_elements(self.triangles.len(), &[2, columns, rows])?;
        let first = self.nodes.len();
        let place = |a: f64, b: f64, k: usize, n: usize| {
            if k == n { b } else { a + (b - a) * k as f64 / n as f64 }
        };
        for j in 0..=rows {
            for i in 0..=columns {
                self.nodes
                    .push([place(from[0], to[0], i, columns), place(from[1], to[1], j, rows)]);
            }
        }
        let block = self.blocks;
        self.blocks += 1;
        for j in 0..rows {
            for i in 0..columns {
                let a = first + j * (columns + 1) + i;
                let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
                let halves =
                    if (i + j) % 2 == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] };
                let triangle = |nodes| Triangle { nodes, block, material };
                self.triangles.extend(halves.map(triangle));
            }
        }
        Ok(first..self.nodes.len())
    }
}

/// How blocks are divided into triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Division {
    /// As few triangles as the corners ask for.
    Fewest,
    /// All triangles meet in the middle of the block, where its shape allows it.
    Middle,
}

/// Divides the blocks of a pattern that is whole.
pub(super) fn divide(pattern: &Pattern, division: Division) -> Result<Mesh, MeshingError> {
    let mut mesh =
        Mesh { nodes: pattern.points.clone(), triangles: Vec::new(), blocks: pattern.blocks.len() };
    for (block, shape) in pattern.blocks.iter().enumerate() {
        divide_block(&mut mesh, &shape.outline, block, shape.material, division)?;
    }
    Ok(without_unused(mesh))
}

/// Divides the blocks of the left half and mirrors them at x = 0. Blocks across the line of
/// symmetry are divided as wholes, around a node in their middle.
pub(super) fn divide_mirrored(pattern: &Pattern, division: Division) -> Result<Mesh, MeshingError> {
    let mut mesh =
        Mesh { nodes: pattern.points.clone(), triangles: Vec::new(), blocks: pattern.blocks.len() };
    let real = real_centre_points(pattern);
    let mut across = Vec::new();
    for (block, shape) in pattern.blocks.iter().enumerate() {
        match shape.centred.then(|| left_side(pattern, &shape.outline)).flatten() {
            None => divide_block(&mut mesh, &shape.outline, block, shape.material, division)?,
            Some(side) => {
                let side: Vec<usize> = side.into_iter().filter(|&p| real[p]).collect();
                across.push((block, shape.material, side));
            }
        }
    }
    let alone = mesh.triangles.len();
    let mut symmetric = Vec::new();
    for (block, material, side) in across {
        let middle = middle_of_whole(pattern, &side);
        let centre = mesh.nodes.len();
        mesh.nodes.push(middle);
        for edge in side.windows(2) {
            mesh.triangles.push(Triangle { nodes: [edge[0], edge[1], centre], block, material });
        }
        // edges that cross the line of symmetry
        for (end, up) in [(side.first(), true), (side.last(), false)] {
            if let Some(&end) = end.filter(|&&end| pattern.points[end][0] != 0.0) {
                symmetric.push((end, centre, up, block, material));
            }
        }
    }
    mirror(&mut mesh, alone, &symmetric, pattern);
    check_turns(&mesh)?;
    Ok(without_unused(mesh))
}

/// Points that are more than the cut through blocks across the line of symmetry.
fn real_centre_points(pattern: &Pattern) -> Vec<bool> {
    let mut real: Vec<bool> = pattern.lines.iter().map(|l| l & line::CENTRE == 0).collect();
    for block in pattern.blocks.iter().filter(|block| !block.centred) {
        for &p in &block.outline {
            real[p] = true;
        }
    }
    real
}

/// The points of half a block from the top of the line of symmetry down its left side to the
/// bottom; none if it has no edge on that line.
fn left_side(pattern: &Pattern, outline: &[usize]) -> Option<Vec<usize>> {
    let n = outline.len();
    let central = |k: usize| pattern.lines[outline[k % n]] & line::CENTRE != 0;
    let top = (0..n).find(|&k| central(k) && !central(k + 1) && central(k + n - 1))?;
    let side: Vec<usize> = (top..top + n).map(|k| outline[k % n]).collect();
    let bottom = side.iter().skip(1).position(|&p| pattern.lines[p] & line::CENTRE != 0)? + 1;
    // between bottom and top nothing but the line itself
    let rest = &side[bottom..];
    rest.iter().all(|&p| pattern.lines[p] & line::CENTRE != 0).then(|| side[..=bottom].to_vec())
}

/// The middle, on the line of symmetry, of a block of which one side is given.
fn middle_of_whole(pattern: &Pattern, side: &[usize]) -> Point {
    let ends = [side.first(), side.last()].map(|p| p.map_or(0.0, |&p| pattern.points[p][1]));
    [0.0, f64::midpoint(ends[0], ends[1])]
}

/// Adds the right half.
fn mirror(
    mesh: &mut Mesh,
    alone: usize,
    symmetric: &[(usize, usize, bool, usize, usize)],
    pattern: &Pattern,
) {
    let left = mesh.nodes.len();
    let mut image = Vec::with_capacity(left);
    for node in 0..left {
        let [x, y] = mesh.nodes[node];
        let central = x == 0.0 && pattern.lines.get(node).is_none_or(|l| l & line::CENTRE != 0);
        if central {
            image.push(node);
        } else {
            image.push(mesh.nodes.len());
            mesh.nodes.push([-x, y]);
        }
    }
    let blocks = mesh.blocks;
    let mut blocks_image: Vec<Option<usize>> = vec![None; blocks];
    // backwards: joints evaluate their points in the order of the edge of their first triangle, each
    // with the strength that the one before left, so images of joints need the other triangle first
    for index in (0..mesh.triangles.len()).rev() {
        let Triangle { nodes: [a, b, c], block, material } = mesh.triangles[index];
        let block = if index < alone {
            *blocks_image[block].get_or_insert_with(|| {
                mesh.blocks += 1;
                mesh.blocks - 1
            })
        } else {
            block
        };
        let nodes = [image[b], image[a], image[c]];
        mesh.triangles.push(Triangle { nodes, block, material });
    }
    for &(end, centre, up, block, material) in symmetric {
        let other = image[end];
        let nodes = if up { [other, end, centre] } else { [end, other, centre] };
        mesh.triangles.push(Triangle { nodes, block, material });
    }
}

/// Divides pairs of triangles of one block right of the line of symmetry along the other
/// diagonal, each triangle once at most, where that gives triangles of a fair shape.
pub(super) fn flip_right_half(mesh: &mut Mesh) {
    let mut flipped = vec![false; mesh.triangles.len()];
    let mut open: BTreeMap<[usize; 2], (usize, usize)> = BTreeMap::new();
    for index in 0..mesh.triangles.len() {
        let here = mesh.triangles[index];
        if here.nodes.iter().any(|&node| mesh.nodes[node][0] < 0.0) {
            continue;
        }
        for k in 0..3 {
            let [a, b, apex] = [0, 1, 2].map(|l| here.nodes[(k + l) % 3]);
            let Some(&(other, opposite)) = open.get(&[b, a]) else {
                open.insert([a, b], (index, apex));
                continue;
            };
            if mesh.triangles[other].block != here.block || flipped[index] || flipped[other] {
                continue;
            }
            let [one, two] = [[apex, a, opposite], [opposite, b, apex]];
            let fair = |nodes: [usize; 3]| quality(nodes.map(|node| mesh.nodes[node])) > FAIR;
            if fair(one) && fair(two) {
                (mesh.triangles[index].nodes, mesh.triangles[other].nodes) = (one, two);
                (flipped[index], flipped[other]) = (true, true);
            }
        }
    }
}

/// Least quality of triangles that other diagonals may make.
const FAIR: f64 = 0.4;

fn check_turns(mesh: &Mesh) -> Result<(), MeshingError> {
    match mesh.triangles.iter().find(|t| mesh.area(t) <= 0.0) {
        None => Ok(()),
        Some(t) => {
            let [x, y] = middle(&mesh.corners(t));
            Err(MeshingError::NoTriangles { x, y })
        }
    }
}

fn divide_block(
    mesh: &mut Mesh,
    outline: &[usize],
    block: usize,
    material: usize,
    division: Division,
) -> Result<(), MeshingError> {
    let corners: Vec<Point> = outline.iter().map(|&p| mesh.nodes[p]).collect();
    let n = corners.len();
    let centre = middle(&corners);
    let star = (0..n).all(|k| quality([corners[k], corners[(k + 1) % n], centre]) > 0.15);
    if division == Division::Middle && star {
        let node = mesh.nodes.len();
        mesh.nodes.push(centre);
        for k in 0..n {
            let nodes = [outline[k], outline[(k + 1) % n], node];
            mesh.triangles.push(Triangle { nodes, block, material });
        }
        return Ok(());
    }
    let Some(found) = best_triangles(&corners) else {
        return Err(MeshingError::NoTriangles { x: centre[0], y: centre[1] });
    };
    mesh.triangles.extend(found.into_iter().map(|t| Triangle {
        nodes: t.map(|k| outline[k]),
        block,
        material,
    }));
    Ok(())
}

/// Shape of a triangle: 1 if all edges are equal, 0 without area, negative if clockwise.
pub(super) fn quality(c: [Point; 3]) -> f64 {
    let squares: f64 = (0..3)
        .map(|k| {
            let (a, b) = (c[k], c[(k + 1) % 3]);
            (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)
        })
        .sum();
    4.0 * 3f64.sqrt() * area(&c) / squares
}

/// The triangles between the corners of a polygon whose worst one is best. All of them run
/// counter-clockwise, which makes them fill the polygon once.
fn best_triangles(corners: &[Point]) -> Option<Vec<[usize; 3]>> {
    let n = corners.len();
    // the worst triangle of the best division of the corners i..=j, and the apex over i j
    let mut worst = vec![vec![f64::INFINITY; n]; n];
    let mut apex = vec![vec![0; n]; n];
    for width in 2..n {
        for i in 0..n - width {
            let j = i + width;
            worst[i][j] = f64::NEG_INFINITY;
            for k in i + 1..j {
                let own = quality([corners[i], corners[k], corners[j]]);
                let value = own.min(worst[i][k]).min(worst[k][j]);
                if value > worst[i][j] {
                    worst[i][j] = value;
                    apex[i][j] = k;
                }
            }
        }
    }
    if n < 3 || worst[0][n - 1] <= 1e-6 {
        return None;
    }
    let mut triangles = Vec::with_capacity(n - 2);
    let mut open = vec![(0, n - 1)];
    while let Some((i, j)) = open.pop() {
        if j - i >= 2 {
            let k = apex[i][j];
            triangles.push([i, k, j]);
            open.extend([(k, j), (i, k)]);
        }
    }
    Some(triangles)
}

/// Numbers the nodes that are used, in their order.
fn without_unused(mut mesh: Mesh) -> Mesh {
    let mut used = vec![false; mesh.nodes.len()];
    mesh.triangles.iter().flat_map(|t| t.nodes).for_each(|node| used[node] = true);
    let mut number = vec![0; used.len()];
    let mut nodes = Vec::new();
    for (node, _) in used.iter().enumerate().filter(|(_, used)| **used) {
        number[node] = nodes.len();
        nodes.push(mesh.nodes[node]);
    }
    for triangle in &mut mesh.triangles {
        triangle.nodes = triangle.nodes.map(|node| number[node]);
    }
    mesh.nodes = nodes;
    mesh
}
