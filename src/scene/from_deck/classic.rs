//! What only decks of the classic dialect have.

use super::{Reader, reader::Offenders};
use crate::mechanics::aperture::Aperture;
use crate::scene::{
    Combination, ElementKind, Elements, InitialAperture, Insertion, Interfaces, JointKind,
    JointPair, JointRestart, LoadRamp, Material, RockJoint, SnapshotSettings,
};
use yformat::diagnostic::Diagnostic;

/// Most characters of a number in a snapshot: beyond, an integer has no room for it.
const MOST_DIGITS: i64 = 9;

/// Type of property sets of joints.
pub(super) const JOINT_TYPE: i64 = 3;

/// Says of each element what it is to the joints, as I1ELTY does, and numbers
/// the property sets of joints behind those of triangles.
pub(super) fn name_joints(reader: &mut Reader<'_>, elements: &mut Elements, sets: usize) {
    let kind = reader.integers("YDE/I1ELTY", -1);
    let is_joint = |e: usize| elements.nodes[e][3] >= 0;
    let wrong = |e: usize| is_joint(e) != (0..=3).contains(&kind(e));
    if let Some(found) = Offenders::find(elements.len(), wrong) {
        let e = found.first;
        reader.report(
            Diagnostic::error(
                "scene::element-kind",
                format!(
                    "element {e} with {} nodes has the kind {}{}",
                    if is_joint(e) { 4 } else { 3 },
                    kind(e),
                    found.more()
                ),
            )
            .at(reader.entry("YDE/I1ELTY", e).or_else(|| reader.entry_at("YDE/I2ELTO", [3, e, 0])))
            .expected("-1 for triangles; 0 (intact), 1 (boundary), 2 (old fracture) or 3 (crack) for joints, which have 4 nodes"),
        );
        return;
    }
    for e in 0..elements.len() {
        elements.joint_kind[e] = match kind(e) {
            0 => JointKind::Intact,
            1 => JointKind::FreeEdge,
            2 => JointKind::PreExisting,
            3 => JointKind::Broken,
            _ => JointKind::NoJoint,
        };
    }
    number_joints(elements, sets);
    find_sides(elements);
}

/// Numbers the property sets of joints behind those of triangles.
pub(super) fn number_joints(elements: &mut Elements, sets: usize) {
    for (property, kind) in elements.property.iter_mut().zip(&elements.joint_kind) {
        if *kind != JointKind::NoJoint {
            *property = property.saturating_add(sets as i32);
        }
    }
}

/// The two triangles of each joint: those whose edges have its nodes.
fn find_sides(elements: &mut Elements) {
    let mut edges = std::collections::HashMap::new();
    for e in 0..elements.len() {
        if elements.joint_kind[e] == JointKind::NoJoint {
            for i in 0..3 {
                let edge = (elements.nodes[e][i], elements.nodes[e][(i + 1) % 3]);
                edges.insert(edge, e as i32);
            }
        }
    }
    for e in 0..elements.len() {
        if elements.joint_kind[e] != JointKind::NoJoint {
            let [a, b, c, d, ..] = elements.nodes[e];
            let triangle = |edge| edges.get(&edge).copied().unwrap_or(-1);
            let first = triangle((a, b));
            let second = if (a, b) == (d, c) { first } else { triangle((c, d)) };
            elements.sides[e] = [first, second];
        }
    }
}

/// Number of the last property set of one of these types, plus one: the arrays of the common table
/// have to be given up to there.
pub(super) fn sets_up_to(reader: &Reader<'_>, types: &[i64]) -> usize {
    let Some(kinds) = reader.integer_field("YDP/I1PTYP") else { return 0 };
    let given = kinds.given_shape().last().copied().unwrap_or(0);
    let sets = usize::try_from(reader.integer("YDP/NPROP")).unwrap_or(0).min(given);
    (0..sets).rev().find(|&set| types.contains(&kinds.get1(set))).map_or(0, |set| set + 1)
}

/// Staged loading.
pub(super) fn ramp(reader: &mut Reader<'_>) -> LoadRamp {
    for (name, what) in
        [("YDC/DCGRST", "time of settling"), ("YDC/DCRMPT", "duration of the load's rise")]
    {
        if !reader.is_given(name) {
            reader.report(
                Diagnostic::warning("scene::ramp", format!("{name}, the {what}, is not given"))
                    .expected(format!("/YD/{name} with a time in seconds"))
                    .help("0 is taken, which loads at once; the original takes whatever lies in its memory"),
            );
        }
    }
    LoadRamp { start: reader.real("YDC/DCGRST"), duration: reader.real("YDC/DCRMPT") }
}

/// Refinement and joint insertion: each material has its own code.
pub(super) fn insertion(reader: &mut Reader<'_>, materials: &[Material]) -> Option<Insertion> {
    let code = reader.integers("YDP/I1PEMN", -1);
    let meshed = |m: &usize| code(*m) > 0 && materials[*m].kind.takes_part_in_contact();
    let combinations: Vec<Combination> = (0..materials.len())
        .filter(meshed)
        .map(|m| Combination { code: code(m), materials: vec![m] })
        .collect();
    if combinations.is_empty() {
        return None;
    }
    let pairs = combinations.iter().filter(|c| c.inserts_joints()).flat_map(|c| &c.materials);
    let pairs: Vec<JointPair> = pairs
        .map(|&m| JointPair { materials: [m as i32; 2], joint_set: materials[m].joint_set })
        .collect();
    let kinds = reader.integers("YDP/I1PTYP", -1);
    let joins = |set: i32| {
        usize::try_from(set).is_ok_and(|set| set < materials.len() && kinds(set) == JOINT_TYPE)
    };
    if let Some(pair) = pairs.iter().find(|pair| !joins(pair.joint_set)) {
        let material = pair.materials[0] as usize;
        reader.report(
            Diagnostic::error(
                "scene::joint-set",
                format!(
                    "property set {material} is to get joints of set {}, which is no joint set",
                    pair.joint_set
                ),
            )
            .at(reader
                .entry("YDP/I1PEJP", material)
                .or_else(|| reader.entry("YDP/I1PEMN", material)))
            .expected("the number of a property set of type 3")
            .help("give it with /YD/YDP/I1PEJP"),
        );
    }
    let capacity = |name| usize::try_from(reader.integer(name)).unwrap_or(0);
    Some(Insertion {
        combinations,
        pairs,
        interfaces: Interfaces::Fractures,
        flags_free_faces: false,
        node_capacity: capacity("YDN/MNOPO"),
        element_capacity: capacity("YDE/MELEM"),
    })
}

/// Properties of the fractures of a joint set.
pub(super) fn rock_joint(reader: &Reader<'_>, set: usize) -> RockJoint {
    let real = |name| reader.reals(name, 0.0)(set);
    RockJoint {
        roughness: real("YDP/D1PJRC"),
        wall_strength: real("YDP/D1PJCS"),
        sample_length: real("YDP/D1PJSL"),
        fluid_pressure: real("YDP/D1PEPF"),
        lame_lambda: real("YDP/D1PELA"),
        shear_modulus: real("YDP/D1PEMU"),
    }
}

/// Where initial apertures come from.
pub(super) fn initial_aperture(reader: &mut Reader<'_>) -> InitialAperture {
    match reader.integer("YDC/ICIATY") {
        0 => InitialAperture::FromRoughness,
        1 => InitialAperture::FromLength,
        other => {
            reader.report(
                Diagnostic::error(
                    "scene::value-range",
                    format!("ICIATY is {other}, which is no kind of initial aperture"),
                )
                .at(reader.place("YDC/ICIATY"))
                .expected("0 (from roughness) or 1 (from fracture length)"),
            );
            InitialAperture::FromRoughness
        }
    }
}

/// Scales and numbers of the `.ym` snapshots and restart decks.
pub(super) fn snapshots(reader: &mut Reader<'_>) -> SnapshotSettings {
    for (name, what) in [
        ("YDC/DCSIZS", "stresses"),
        ("YDC/DCSIZD", "shear displacements"),
        ("YDC/DCSIZA", "apertures"),
    ] {
        if !reader.is_given(name) {
            reader.report(
                Diagnostic::warning(
                    "scene::output-scale",
                    format!("{name}, the scale of {what} in snapshots, is not given"),
                )
                .expected(format!("/YD/{name} with {}", usual_scale(name)))
                .help("a default is taken here; the original takes whatever lies in its memory"),
            );
        }
    }
    let digits = reader.integer("YDC/ICOUTP");
    if !(1..=MOST_DIGITS).contains(&digits) {
        reader.report(
            Diagnostic::error(
                "scene::value-range",
                format!("ICOUTP asks for {digits} characters for each number of a snapshot"),
            )
            .at(reader.place("YDC/ICOUTP"))
            .expected(format!("1 to {MOST_DIGITS}; decks use 4")),
        );
    }
    check_scales(reader);
    let number = |name| u64::try_from(reader.integer(name)).unwrap_or(0);
    let real = |name| reader.real(name);
    SnapshotSettings {
        coordinate: real("YDC/DCSIZC"),
        force: real("YDC/DCSIZF"),
        stress: real("YDC/DCSIZS"),
        velocity: real("YDC/DCSIZV"),
        displacement: real("YDC/DCSIZD"),
        aperture: real("YDC/DCSIZA"),
        digits: u8::try_from(digits).unwrap_or(2),
        first_number: number("YDC/ICOUTI"),
        restart_interval: number("YDC/ICSAVF"),
    }
}

/// What the scale of a quantity in snapshots should be.
fn usual_scale(name: &str) -> &'static str {
    if name == APERTURE_SCALE {
        "an aperture above 0 and other than 1, such as 1e-7"
    } else {
        "a value that no result exceeds"
    }
}

/// Scale of apertures, which are shown as logarithms.
const APERTURE_SCALE: &str = "YDC/DCSIZA";

/// Snapshots show values divided by their scales.
fn check_scales(reader: &mut Reader<'_>) {
    for name in
        ["YDC/DCSIZC", "YDC/DCSIZF", "YDC/DCSIZS", "YDC/DCSIZV", "YDC/DCSIZD", APERTURE_SCALE]
    {
        let value = reader.real(name);
        if value == 0.0 || (name == APERTURE_SCALE && (value < 0.0 || value == 1.0)) {
            reader.report(
                Diagnostic::warning(
                    "scene::output-scale",
                    format!("{name} is {value}: what it scales cannot be read from snapshots"),
                )
                .at(reader.place(name))
                .expected(usual_scale(name)),
            );
        }
    }
}

/// What a restart deck says about joints.
pub(super) fn joint_restart(reader: &mut Reader<'_>, elements: usize) -> Option<JointRestart> {
    if reader.integer("YDC/NCSTEP") == 0 || !reader.knows("YDJ/NJOINT") {
        return None;
    }
    let strengths = reader.real_field("YDE/D2ELFS").filter(|f| f.item().is_some());
    let strengths =
        strengths.map(|f| (0..elements).map(|e| [0, 1, 2].map(|point| f.get2(point, e))).collect());
    let joints = usize::try_from(reader.integer("YDJ/NJOINT")).unwrap_or(0).min(elements);
    let value = |name| reader.reals(name, 0.0);
    let (kni, knc, ksc) = (value("YDJ/D1JKNI"), value("YDJ/D1JKNC"), value("YDJ/D1JKSC"));
    let (nst, sst) = (value("YDJ/D1JNST"), value("YDJ/D1JSST"));
    let (api, apc, aph, apr) =
        (value("YDJ/D1JAPI"), value("YDJ/D1JAPC"), value("YDJ/D1JAPH"), value("YDJ/D1JAPR"));
    let (sdc, dlc, sdp, efl) =
        (value("YDJ/D1JSDC"), value("YDJ/D1JDLC"), value("YDJ/D1JSDP"), value("YDJ/D1JEFL"));
    let (jrc, jcs, phi) = (value("YDJ/D1JJRC"), value("YDJ/D1JJCS"), value("YDJ/D1JPHI"));
    let (fmd, fpr, fet) = (value("YDJ/D1JFMD"), value("YDJ/D1JFPR"), value("YDJ/D1JFET"));
    let apertures = (0..joints).map(|j| Aperture {
        initial_stiffness: kni(j),
        normal_stiffness: knc(j),
        shear_stiffness: ksc(j),
        normal_stress: nst(j),
        shear_stress: sst(j),
        initial: api(j),
        current: apc(j),
        hydraulic: aph(j),
        residual: apr(j),
        slip: sdc(j),
        dilation: dlc(j),
        peak_slip: sdp(j),
        length: efl(j),
        roughness: jrc(j),
        wall_strength: jcs(j),
        asperity_angle: phi(j),
        failure_mode: fmd(j),
        fluid_pressure: fpr(j),
        entry_time: fet(j),
    });
    Some(JointRestart { strengths, apertures: apertures.collect() })
}

/// Kind of a property set of the common table.
pub(super) fn kind(reader: &mut Reader<'_>, set: usize, code: i64) -> ElementKind {
    match code {
        1 => ElementKind::ElasticTriangle,
        2 => ElementKind::RigidTriangle,
        4 => {
            reader.report(
                Diagnostic::error(
                    "scene::not-simulated",
                    format!("property set {set} has type 4 (softening triangles), which the original cannot run in this dialect"),
                )
                .at(reader.entry("YDP/I1PTYP", set))
                .expected("1 (elastic), 2 (rigid), 3 (joints) or -1 (nodes)")
                .help("use joints (type 3) for fracture"),
            );
            ElementKind::Inert(code)
        }
        _ => ElementKind::Inert(code),
    }
}
