//! Refinement, joint insertion and separation before the first step (spec
//! `y2d3d.md` D.1 to D.3).
//!
//! Codes are decimal: each of ten passes takes the last digit of every
//! combination's code, so `31` refines first and inserts joints then.

mod families;
mod joints;
mod refine;
mod solids;
mod trace;

use crate::scene::{Elements, FractureNetwork, Insertion, Material, Nodes, Scene};
use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use families::Families;
pub use solids::{execute_in_space, room_needed_in_space};

/// Number of passes, enough for the digits of any code.
const PASSES: usize = 10;

/// A mesh that has no room for what is to be inserted.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error(
    "the mesh needs {needed} {what} after {stage}, but the deck's {keyword} leaves room for {capacity}: \
     raise {keyword} to {needed} or more"
)]
pub struct CapacityError {
    /// `nodes` or `elements`.
    pub what: &'static str,
    /// The deck's keyword that declares the capacity.
    pub keyword: &'static str,
    /// What was being done.
    pub stage: &'static str,
    /// Entities needed so far.
    pub needed: usize,
    /// Entities declared.
    pub capacity: usize,
}

/// What a mesh comes to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Room {
    /// Nodes.
    pub nodes: usize,
    /// Elements, joints among them.
    pub elements: usize,
}

/// Most nodes or elements that are made only to count them.
const MOST_COUNTED: usize = 4_000_000;

/// The room that a scene's mesh needs when everything is inserted, if that is not absurdly much.
#[must_use]
pub fn room_needed(scene: &Scene) -> Option<Room> {
    let mut scene = scene.clone();
    let mut insertion = scene.insertion.take()?;
    insertion.node_capacity = MOST_COUNTED;
    insertion.element_capacity = MOST_COUNTED;
    let network = scene.fracture_network.as_ref();
    let (nodes, elements) = (&mut scene.nodes, &mut scene.elements);
    execute(&mut insertion, nodes, elements, &mut scene.materials, network).ok()?;
    Some(Room { nodes: scene.nodes.len(), elements: scene.elements.len() })
}

/// What the passes did.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct InsertionReport {
    /// Digits executed.
    pub executed: usize,
    /// Whether a combination was skipped because its last material cannot be
    /// meshed; the original warns once per step then.
    pub skipped_combination: bool,
}

/// The mesh that is being changed.
struct Mesh<'a> {
    nodes: &'a mut Nodes<2>,
    elements: &'a mut Elements,
    materials: &'a [Material],
    insertion: &'a Insertion,
    network: Option<&'a FractureNetwork>,
    stage: &'static str,
}

impl Mesh<'_> {
    fn check_capacity(&self) -> Result<(), CapacityError> {
        let check = |what, keyword, needed, capacity| {
            if needed > capacity {
                let stage = self.stage;
                return Err(CapacityError { what, keyword, stage, needed, capacity });
            }
            Ok(())
        };
        check("nodes", "MNOPO", self.nodes.len(), self.insertion.node_capacity)?;
        check("elements", "MELEM", self.elements.len(), self.insertion.element_capacity)
    }

    /// Property code of joints of the last table row that joins the two materials.
    fn joint_property(&self, a: i32, b: i32) -> Option<i32> {
        self.insertion
            .pairs
            .iter()
            .rev()
            .find(|pair| {
                let [p, q] = pair.materials;
                (p, q) == (a, b) || (p, q) == (b, a)
            })
            .map(|pair| self.materials.len() as i32 + pair.joint_set)
    }
}

/// Executes all meshing codes and sets them to 0.
///
/// # Errors
/// If nodes or elements exceed what the deck declares.
pub fn execute(
    insertion: &mut Insertion,
    nodes: &mut Nodes<2>,
    elements: &mut Elements,
    materials: &mut [Material],
    network: Option<&FractureNetwork>,
) -> Result<InsertionReport, CapacityError> {
    name_joint_sets(insertion, materials);
    let mut report = InsertionReport::default();
    let mut codes: Vec<i64> = insertion.combinations.iter().map(|c| c.code).collect();
    for _ in 0..PASSES {
        execute_pass(&mut codes, insertion, nodes, elements, materials, network, &mut report)?;
    }
    use_up(insertion);
    Ok(report)
}

/// Gives each material the joint set that the table names for its inside.
fn name_joint_sets(insertion: &Insertion, materials: &mut [Material]) {
    for pair in &insertion.pairs {
        let [p, q] = pair.materials;
        let inside = usize::try_from(p).ok().filter(|_| p == q);
        if let Some(material) = inside.and_then(|m| materials.get_mut(m)) {
            material.joint_set = pair.joint_set;
        }
    }
}

fn use_up(insertion: &mut Insertion) {
    for combination in &mut insertion.combinations {
        combination.code = 0;
    }
}

/// What [`execute`] leaves behind besides the mesh, for a mesh that has been changed already.
pub fn skip(insertion: &mut Insertion, materials: &mut [Material]) {
    name_joint_sets(insertion, materials);
    use_up(insertion);
}

fn execute_pass(
    codes: &mut [i64],
    insertion: &Insertion,
    nodes: &mut Nodes<2>,
    elements: &mut Elements,
    materials: &[Material],
    network: Option<&FractureNetwork>,
    report: &mut InsertionReport,
) -> Result<(), CapacityError> {
    // elements and nodes made in this pass are not processed in it, and the
    // lists of mid nodes are shared by its combinations
    let (old_elements, old_nodes) = (elements.len(), nodes.len());
    let properties = elements.property.clone();
    let mut mid_nodes = refine::MidNodes::new(old_nodes);
    for (code, combination) in codes.iter_mut().zip(&insertion.combinations) {
        let digit = *code % 10;
        *code /= 10;
        let meshable = combination
            .materials
            .last()
            .and_then(|&m| materials.get(m))
            .is_some_and(|m| m.kind.takes_part_in_contact());
        report.skipped_combination |= !meshable && digit > 0;
        if digit <= 0 || !meshable {
            continue;
        }
        let listed = |&e: &usize| {
            usize::try_from(properties[e]).is_ok_and(|p| combination.materials.contains(&p))
        };
        let tagged: Vec<usize> = (0..old_elements).filter(listed).collect();
        let first = combination.materials.first().copied();
        let mut mesh = Mesh { nodes, elements, materials, insertion, network, stage: "refinement" };
        report.executed += 1;
        match digit {
            1 => refine::into_four(&mut mesh, &tagged, first, &mut mid_nodes)?,
            2 => refine::into_six(&mut mesh, &tagged, first, &mut mid_nodes)?,
            3 => {
                mesh.stage = "joint insertion";
                joints::insert(&mut mesh, &tagged, old_nodes)?;
            }
            4 => {
                mesh.stage = "separation";
                let only: Vec<usize> = tagged
                    .into_iter()
                    .filter(|&e| usize::try_from(properties[e]).ok() == first)
                    .collect();
                joints::separate(&mut mesh, &only)?;
            }
            _ => {}
        }
    }
    Ok(())
}
