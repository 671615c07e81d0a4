//! The deck that a mesh is the skeleton of.

use yformat::deck::{Deck, DeckBuilder};
use yformat::dialect::Dialect;

use super::error::GmshError;
use super::mesh::Mesh;
use super::plane::{Group, PlaneMesh, plane_mesh};

/// A deck made from a mesh.
#[derive(Debug, Clone)]
pub struct Skeleton {
    /// A complete deck of the split dialect.
    pub deck: Deck,
    /// What of the mesh it does not say.
    pub warnings: Vec<String>,
}

/// Placeholder values: a concrete. Comments in the deck mark them.
mod placeholder {
    /// Young's modulus, Pa.
    pub(super) const YOUNG: f64 = 20e9;
    /// Poisson's ratio.
    pub(super) const POISSON: f64 = 0.2;
    /// Density, kg/m³.
    pub(super) const DENSITY: f64 = 2400.0;
    /// Part of the damping at which elements of the size of the smallest one are critically
    /// damped.
    pub(super) const DAMPING: f64 = 0.1;
    /// Coulomb friction.
    pub(super) const FRICTION: f64 = 0.6;
    /// Tensile strength of joints, Pa.
    pub(super) const TENSILE_STRENGTH: f64 = 2e6;
    /// Cohesion of joints, Pa.
    pub(super) const COHESION: f64 = 5e6;
    /// Fracture energy of joints, J/m².
    pub(super) const FRACTURE_ENERGY: f64 = 100.0;
    /// Gravity, m/s².
    pub(super) const GRAVITY: f64 = -9.81;
    /// Steps of the run.
    pub(super) const STEPS: i64 = 10_000;
}

/// Makes a complete deck of the split dialect (spec `deck.md` 3) from a mesh; `source` is what its
/// first comment calls the mesh.
///
/// Each physical surface is an element set, in order of the tags, elements of none are a set of
/// their own. Each physical curve and point is a node set; set 0 has all other nodes. Node sets
/// are free, except those whose name contains `fix` or `support`: they do not move. Quadrangles
/// become two triangles, clockwise triangles are turned, nodes without triangles are dropped.
///
/// Material values are placeholders. The time step is a tenth of the time in which the
/// compression wave crosses the smallest triangle.
///
/// # Errors
/// If the mesh is not a plane mesh of triangles and quadrangles with areas.
pub fn skeleton(mesh: &Mesh, source: &str) -> Result<Skeleton, GmshError> {
    let plane = plane_mesh(mesh)?;
    let size = smallest_height(&plane);
    let builder = DeckBuilder::new(Dialect::Split);
    let builder = control(header(builder, source), size);
    let builder = nodes(builder, &plane);
    let builder = node_sets(builder, mesh, &plane);
    let builder = elements(builder, &plane);
    let builder = interaction(builder, &plane, size);
    let builder = builder.comment("History: the kinetic energy").kinetic_energy_history(0.05);
    let builder = element_sets(builder, mesh, &plane, size);
    let builder = joint_sets(builder, &plane);
    Ok(Skeleton { deck: builder.run().stop().build(), warnings: plane.warnings })
}

fn lame() -> (f64, f64) {
    use placeholder::{POISSON, YOUNG};
    let shear = YOUNG / (2.0 * (1.0 + POISSON));
    (YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON)), shear)
}

/// The least height of a triangle, m.
fn smallest_height(plane: &PlaneMesh) -> f64 {
    let height = |triangle: &[usize; 3]| {
        let [a, b, c] = triangle.map(|node| plane.nodes.get(node).copied().unwrap_or_default());
        let length = |p: [f64; 2], q: [f64; 2]| (q[0] - p[0]).hypot(q[1] - p[1]);
        let longest = length(a, b).max(length(b, c)).max(length(c, a));
        let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        double_area / longest
    };
    plane.triangles.iter().map(height).fold(f64::MAX, f64::min).max(f64::MIN_POSITIVE)
}

/// Rounded to three digits, so that people can read it.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

fn header(builder: DeckBuilder, source: &str) -> DeckBuilder {
    builder
        .comment(format!("Made by ypsilon convert from the Gmsh mesh {source}."))
        .comment(
            "Everything but the mesh is a placeholder: look at gravity, steps, materials and node \
             sets before you believe a result. Units: m, kg, s, N, Pa.",
        )
        .comment(
            "Nodes are free except in sets whose name contains fix or support: those have the \
             velocity 0 in x and y (code 3).",
        )
}

fn control(builder: DeckBuilder, size: f64) -> DeckBuilder {
    let (lambda, mu) = lame();
    let wave_speed = ((lambda + 2.0 * mu) / placeholder::DENSITY).sqrt();
    let step = rounded(0.1 * size / wave_speed).max(f64::MIN_POSITIVE);
    builder
        .comment(format!(
            "PLACEHOLDER time step: 0.1 h / c_p with the smallest height of a triangle h = {:.3e} m \
             and c_p = {wave_speed:.0} m/s",
            size
        ))
        .real("YDC/DCSTEC", step)
        .integer("YDC/MCSTEP", placeholder::STEPS)
        .integer("YDC/NCSTEP", 0)
        .real("YDC/DCTIME", 0.0)
        .real("YDC/DCGRAY", placeholder::GRAVITY)
        .integer("YDC/ICOUTF", placeholder::STEPS / 50)
        .integer("YDC/ICOUTI", 0)
        .integer("YDC/ICOUTP", 4)
}

fn integers(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}

fn nodes(builder: DeckBuilder, plane: &PlaneMesh) -> DeckBuilder {
    let coordinates: Vec<f64> = plane.nodes.iter().flatten().copied().collect();
    let flags = plane.on_boundary.iter().map(|&flag| i64::from(flag)).collect();
    let sets = plane.node_set.iter().map(|&set| integers(set)).collect();
    let room = plane.nodes.len() + 3 * plane.triangles.len();
    builder
        .comment("Nodes, with room for the nodes of joints")
        .integer("YDN/MNODIM", 2)
        .integer("YDN/NNODIM", 2)
        .integer("YDN/MNOPO", integers(room))
        .integer("YDN/NNOPO", integers(plane.nodes.len()))
        .reals2("YDN/D2NCI", 2, coordinates.clone())
        .reals2("YDN/D2NCC", 2, coordinates)
        .reals2("YDN/D2NVC", 2, vec![0.0; 2 * plane.nodes.len()])
        .integers("YDN/I1NOBF", flags)
        .integers("YDN/I1NOPR", sets)
}

fn is_support(name: &str) -> bool {
    let name = name.to_lowercase();
    name.contains("fix") || name.contains("support")
}

fn group_text(mesh: &Mesh, (dimension, tag): Group) -> String {
    let kind = match dimension {
        0 => "point",
        1 => "curve",
        _ => "surface",
    };
    match mesh.group_name(dimension, tag) {
        Some(name) => format!("{name} (physical {kind} {tag})"),
        None => format!("physical {kind} {tag}"),
    }
}

fn node_sets(builder: DeckBuilder, mesh: &Mesh, plane: &PlaneMesh) -> DeckBuilder {
    let sets = plane.node_sets.len() + 1;
    let mut codes = vec![1];
    let mut builder = builder.comment("Node set 0: all other nodes, free");
    for (index, &group) in plane.node_sets.iter().enumerate() {
        let fixed = mesh.group_name(group.0, group.1).is_some_and(is_support);
        codes.push(if fixed { 3 } else { 1 });
        let state = if fixed { "fixed" } else { "free" };
        builder = builder.comment(format!(
            "Node set {}: {}, {state}",
            index + 1,
            group_text(mesh, group)
        ));
    }
    builder
        .integer("YDPN/MPNSET", integers(sets))
        .integer("YDPN/NPNSET", integers(sets))
        .comment("Codes: 1 force (N per node), 2 acceleration, 3 velocity")
        .integers("YDPN/I1PNFX", codes.clone())
        .integers("YDPN/I1PNFY", codes)
        .reals("YDPN/D1PNAX", vec![0.0; sets])
        .reals("YDPN/D1PNAY", vec![0.0; sets])
        .comment("Pressure and traction on edges whose two nodes have one, Pa")
        .reals("YDPN/D1PNAP", vec![0.0; sets])
        .reals("YDPN/D1PNAT", vec![0.0; sets])
}

fn elements(builder: DeckBuilder, plane: &PlaneMesh) -> DeckBuilder {
    let count = plane.triangles.len();
    let corners = plane.triangles.iter().flatten().map(|&node| integers(node)).collect();
    let sets = plane.element_set.iter().map(|&set| integers(set)).collect();
    builder
        .comment("Triangles, with room for joints: at most three each")
        .integer("YDE/MELEM", integers(4 * count))
        .integer("YDE/NELEM", integers(count))
        .integer("YDE/MELST", 2)
        .integer("YDE/NELST", 2)
        .integer("YDE/MELNO", 4)
        .integer("YDE/NELNO", 3)
        .integers("YDE/I1ELPR", sets)
        .integers2("YDE/I2ELTO", 3, corners)
}

fn interaction(builder: DeckBuilder, plane: &PlaneMesh, size: f64) -> DeckBuilder {
    let couples = 40 * plane.triangles.len() + 1000;
    builder
        .comment("Contact: PLACEHOLDER buffer and number of couples")
        .integer("YDI/MICOUP", integers(couples))
        .integer("YDI/NICOUP", 0)
        .integer("YDI/MISTATE", 6)
        .integer("YDI/IIECFF", -2)
        .real("YDI/DIEDI", 200.0)
        .real("YDI/DIEZON", rounded(0.2 * size))
}

fn element_sets(
    mut builder: DeckBuilder,
    mesh: &Mesh,
    plane: &PlaneMesh,
    size: f64,
) -> DeckBuilder {
    use placeholder::{DAMPING, DENSITY, FRICTION, POISSON, YOUNG};
    for (index, set) in plane.element_sets.iter().enumerate() {
        let what = set.map_or_else(
            || "triangles of no physical surface".to_owned(),
            |tag| group_text(mesh, (2, tag)),
        );
        builder = builder.comment(format!("Element set {index}: {what}"));
    }
    let sets = plane.element_sets.len();
    let (lambda, mu) = lame();
    let all = |value: f64| vec![value; sets];
    let viscosity = rounded(2.0 * size * DAMPING * (YOUNG * DENSITY).sqrt());
    builder
        .integer("YDPE/MPROP", integers(sets))
        .integer("YDPE/NPROP", integers(sets))
        .comment(format!(
            "PLACEHOLDER material: E = {YOUNG:.0e} Pa, Poisson's ratio {POISSON}, a concrete in \
             plane strain"
        ))
        .reals("YDPE/D1PELA", all(rounded(lambda)))
        .reals("YDPE/D1PEMU", all(rounded(mu)))
        .reals("YDPE/D1PERO", all(DENSITY))
        .comment(format!("PLACEHOLDER damping: {DAMPING} of critical for the smallest triangle"))
        .reals("YDPE/D1PEKS", all(viscosity))
        .comment("PLACEHOLDER contact: penalties 10 E and 1 E, friction")
        .reals("YDPE/D1PEPE", all(10.0 * YOUNG))
        .reals("YDPE/D1PEPT", all(YOUNG))
        .reals("YDPE/D1PEFR", all(FRICTION))
        .reals("YDPE/D1PSEM", all(0.0))
        .integers("YDPE/I1PEFR", vec![0; sets])
        .integers("YDPE/I1PEMB", vec![1; sets])
        .integers("YDPE/I1PSDE", vec![0; sets])
        .integers("YDPE/I1PTYP", vec![1; sets])
}

fn joint_sets(builder: DeckBuilder, plane: &PlaneMesh) -> DeckBuilder {
    use placeholder::{COHESION, FRACTURE_ENERGY, FRICTION, TENSILE_STRENGTH, YOUNG};
    let sets = plane.element_sets.len();
    let mut record = vec![integers(sets), 0];
    record.extend((0..sets).map(integers));
    let inside = (0..sets).map(|set| (set, set));
    let pairs: Vec<i64> = inside
        .chain(plane.neighbours.iter().copied())
        .flat_map(|(a, b)| [integers(a), integers(b), 0])
        .collect();
    builder
        .comment("Joint set 0: PLACEHOLDER strengths")
        .integer("YDPJ/MPJSET", 1)
        .integer("YDPJ/NPJSET", 1)
        .reals("YDPJ/D1PJFT", vec![TENSILE_STRENGTH])
        .reals("YDPJ/D1PJFS", vec![COHESION])
        .reals("YDPJ/D1PJCO", vec![COHESION])
        .reals("YDPJ/D1PJFR", vec![FRICTION])
        .reals("YDPJ/D1PJGF", vec![FRACTURE_ENERGY])
        .reals("YDPJ/D1PJPE", vec![10.0 * YOUNG])
        .integers("YDPJ/I1PSDE", vec![0])
        .integers("YDPJ/I1PTYP", vec![3])
        .comment(
            "The second number is the mesh code: 0 nothing, 3 joints between all triangles, 1 each \
             triangle into four, 31 first refine, then joints. Refinement needs a larger MNOPO, \
             MELEM and MICOUP and a smaller time step.",
        )
        .integer("YDPM/MPMCOM", 1)
        .integer("YDPM/MPMCOL", integers(sets + 2))
        .integers2("YDPM/I2PMSET", sets + 2, record)
        .comment("Joint set of each pair of element sets")
        .integer("YDPM/MPMROW", integers(pairs.len() / 3))
        .integers2("YDPM/I2PMIJ", 3, pairs)
}
