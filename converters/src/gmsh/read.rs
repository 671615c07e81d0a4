//! The sections of a `.msh` file, versions 2.2 and 4.1.

use std::collections::BTreeMap;

use super::error::GmshError;
use super::mesh::{Element, ElementKind, Mesh, Node, PhysicalName};
use super::scan::Scanner;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Version {
    V22,
    V41,
}

/// Physical group of a geometric entity, by dimension and tag: of several the one with the
/// greatest tag.
type EntityGroups = BTreeMap<(i64, i64), i64>;

/// Reads the text of a `.msh` file.
///
/// ```
/// use ypsilon_converters::gmsh::parse_msh;
///
/// let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n\
///             $Elements\n1\n1 2 2 7 1 1 2 3\n$EndElements\n";
/// let mesh = parse_msh(text.as_bytes())?;
/// assert_eq!(mesh.elements[0].group, Some(7));
/// # Ok::<(), ypsilon_converters::gmsh::GmshError>(())
/// ```
///
/// # Errors
/// With the line of what does not fit the format. Numbers of nodes and groups are not checked
/// against each other here.
pub fn parse_msh(text: &[u8]) -> Result<Mesh, GmshError> {
    let mut scanner = Scanner::new(text);
    if scanner.take("$MeshFormat").is_err() {
        return Err(GmshError::NoMesh);
    }
    let version = format(&mut scanner)?;
    let mut mesh = Mesh::default();
    let mut groups = EntityGroups::new();
    let (mut has_nodes, mut has_elements) = (false, false);
    loop {
        let mut ahead = scanner.clone();
        let Some(section) = ahead.word() else { break };
        match section {
            b"$PhysicalNames" => names(&mut ahead, &mut mesh.names)?,
            b"$Entities" => entities(&mut ahead, &mut groups, &mut mesh.notes)?,
            b"$Nodes" => {
                has_nodes = true;
                match version {
                    Version::V22 => nodes_22(&mut ahead, &mut mesh.nodes)?,
                    Version::V41 => nodes_41(&mut ahead, &mut mesh.nodes)?,
                }
            }
            b"$Elements" => {
                has_elements = true;
                match version {
                    Version::V22 => elements_22(&mut ahead, &mut mesh.elements)?,
                    Version::V41 => elements_41(&mut ahead, &groups, &mut mesh.elements)?,
                }
            }
            b"$PartitionedEntities" | b"$ParametricNodes" => {
                return Err(scanner.unexpected("a mesh that is neither partitioned nor parametric"));
            }
            other if other.starts_with(b"$") && !other.starts_with(b"$End") => {
                skip(&mut ahead, other)?;
            }
            _ => return Err(scanner.unexpected("the beginning of a section")),
        }
        scanner = ahead;
    }
    match (has_nodes, has_elements) {
        (true, true) => Ok(mesh),
        (false, _) => Err(GmshError::NoSection("Nodes")),
        (true, false) => Err(GmshError::NoSection("Elements")),
    }
}

fn format(scanner: &mut Scanner<'_>) -> Result<Version, GmshError> {
    let line = scanner.line();
    let word = scanner.word().unwrap_or_default();
    let version = match word {
        b"2" | b"2.0" | b"2.1" | b"2.2" => Version::V22,
        b"4.1" => Version::V41,
        other => {
            let version = String::from_utf8_lossy(other).chars().take(20).collect();
            return Err(GmshError::Version { line, version });
        }
    };
    match scanner.integer("file type 0 (text) or 1 (binary)")? {
        0 => {}
        _ => return Err(GmshError::Binary { line }),
    }
    let _ = scanner.integer("the size of a real")?;
    scanner.take("$EndMeshFormat")?;
    Ok(version)
}

/// Skips a section that says nothing about the mesh, such as `$Periodic`.
fn skip(scanner: &mut Scanner<'_>, section: &[u8]) -> Result<(), GmshError> {
    let end = [b"$End", section.get(1..).unwrap_or_default()].concat();
    loop {
        match scanner.word() {
            None => return Err(scanner.unexpected("the end of a section ($End...)")),
            Some(word) if word == end => return Ok(()),
            Some(_) => {}
        }
    }
}

fn names(scanner: &mut Scanner<'_>, names: &mut Vec<PhysicalName>) -> Result<(), GmshError> {
    for _ in 0..scanner.count("the number of physical names")? {
        let dimension = scanner.integer("the dimension of a physical group")?;
        let tag = scanner.integer("the tag of a physical group")?;
        let line = String::from_utf8_lossy(scanner.rest_of_line());
        let name = line.trim().trim_matches('"').to_owned();
        names.push(PhysicalName { dimension, tag, name });
    }
    scanner.take("$EndPhysicalNames")
}

fn entities(
    scanner: &mut Scanner<'_>,
    groups: &mut EntityGroups,
    notes: &mut Vec<String>,
) -> Result<(), GmshError> {
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = scanner.count("the number of entities")?;
    }
    for (dimension, count) in (0_i64..).zip(counts) {
        for _ in 0..count {
            let tag = scanner.integer("the tag of an entity")?;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                let _ = scanner.real("a coordinate of an entity")?;
            }
            let of_entity = scanner.count("the number of physical groups")?;
            let mut greatest = None;
            for _ in 0..of_entity {
                let group = scanner.integer("the tag of a physical group")?.saturating_abs();
                greatest = greatest.max(Some(group));
            }
            if dimension > 0 {
                for _ in 0..scanner.count("the number of bounding entities")? {
                    let _ = scanner.integer("the tag of a bounding entity")?;
                }
            }
            if let Some(group) = greatest {
                groups.insert((dimension, tag), group);
                if of_entity > 1 {
                    let what = ["point", "curve", "surface", "volume"];
                    let what = what.get(dimension as usize).copied().unwrap_or_default();
                    notes.push(format!(
                        "{what} {tag} is in {of_entity} physical groups: group {group} counts"
                    ));
                }
            }
        }
    }
    scanner.take("$EndEntities")
}

fn position(scanner: &mut Scanner<'_>) -> Result<[f64; 3], GmshError> {
    let mut position = [0.0; 3];
    for coordinate in &mut position {
        *coordinate = scanner.real("a coordinate")?;
    }
    Ok(position)
}

fn nodes_22(scanner: &mut Scanner<'_>, nodes: &mut Vec<Node>) -> Result<(), GmshError> {
    for _ in 0..scanner.count("the number of nodes")? {
        let tag = scanner.integer("a node number")?;
        nodes.push(Node { tag, position: position(scanner)? });
    }
    scanner.take("$EndNodes")
}

fn nodes_41(scanner: &mut Scanner<'_>, nodes: &mut Vec<Node>) -> Result<(), GmshError> {
    let blocks = scanner.count("the number of node blocks")?;
    for what in ["the number of nodes", "the least node number", "the greatest node number"] {
        let _ = scanner.count(what)?;
    }
    for _ in 0..blocks {
        let dimension = scanner.count("the dimension of an entity")?;
        let _ = scanner.integer("the tag of an entity")?;
        let parametric = scanner.integer("0, or 1 for parametric nodes")? != 0;
        let mut tags = Vec::new();
        for _ in 0..scanner.count("the number of nodes of a block")? {
            tags.push(scanner.integer("a node number")?);
        }
        for tag in tags {
            nodes.push(Node { tag, position: position(scanner)? });
            if parametric {
                for _ in 0..dimension {
                    let _ = scanner.real("a parametric coordinate")?;
                }
            }
        }
    }
    scanner.take("$EndNodes")
}

fn elements_22(scanner: &mut Scanner<'_>, elements: &mut Vec<Element>) -> Result<(), GmshError> {
    for _ in 0..scanner.count("the number of elements")? {
        let tag = scanner.integer("an element number")?;
        let kind = kind(scanner)?;
        let mut group = None;
        for index in 0..scanner.count("the number of tags")? {
            let value = scanner.integer("a tag")?;
            if index == 0 && value != 0 {
                group = Some(value.saturating_abs());
            }
        }
        let nodes = element_nodes(scanner, kind)?;
        elements.push(Element { tag, kind, nodes, group });
    }
    scanner.take("$EndElements")
}

fn elements_41(
    scanner: &mut Scanner<'_>,
    groups: &EntityGroups,
    elements: &mut Vec<Element>,
) -> Result<(), GmshError> {
    let blocks = scanner.count("the number of element blocks")?;
    for what in
        ["the number of elements", "the least element number", "the greatest element number"]
    {
        let _ = scanner.count(what)?;
    }
    for _ in 0..blocks {
        let dimension = scanner.count("the dimension of an entity")?;
        let entity = scanner.integer("the tag of an entity")?;
        let kind = kind(scanner)?;
        let group = groups.get(&(dimension, entity)).copied();
        for _ in 0..scanner.count("the number of elements of a block")? {
            let tag = scanner.integer("an element number")?;
            let nodes = element_nodes(scanner, kind)?;
            elements.push(Element { tag, kind, nodes, group });
        }
    }
    scanner.take("$EndElements")
}

fn element_nodes(scanner: &mut Scanner<'_>, kind: ElementKind) -> Result<Vec<i64>, GmshError> {
    (0..kind.nodes()).map(|_| scanner.integer("a node number")).collect()
}

/// The element type of Gmsh's numbering, as far as plane decks have it.
fn kind(scanner: &mut Scanner<'_>) -> Result<ElementKind, GmshError> {
    let line = scanner.line();
    let number = scanner.integer("an element type")?;
    let (kind, remedy) = match number {
        15 => return Ok(ElementKind::Point),
        1 => return Ok(ElementKind::Line),
        2 => return Ok(ElementKind::Triangle),
        3 => return Ok(ElementKind::Quadrangle),
        4..=7 => ("a solid element", "mesh surfaces only (`gmsh -2 ...`)"),
        8..=14 | 16..=66 | 69..=133 => {
            ("an element of higher order", "set the element order to 1 (`gmsh -2 -order 1 ...`)")
        }
        _ => ("unknown", "expected points (15), lines (1), triangles (2) and quadrangles (3)"),
    };
    Err(GmshError::ElementType { line, number, kind, remedy })
}
