//! Scenes of `.Y3D` decks (spec `y3d.md` 1): one table of property sets for elements and joints,
//! boundary sets in `YDB`, pressures on surface triangles in `YDX`.

mod boundary;
mod contact;
mod elements;
mod faces;
mod joints;
mod materials;
mod unsupported;

use super::{Reader, control, geometry::Shapes, nodes, probes};
use crate::scene::{Conventions, FailedJoints, InitialAperture, JointPoints, Scene, SeismicMethod};

/// The scene of a deck; `None` where it is not complete enough to be looked at.
pub(super) fn build(reader: &mut Reader<'_>, name: &str) -> Option<Scene<3>> {
    super::unsupported::check(reader);
    unsupported::check(reader);
    let control = control::read(reader, 3);
    let nodes = nodes::read::<3>(reader)?;
    let materials = materials::read(reader);
    let mut elements = elements::read(reader, nodes.len(), &materials)?;
    elements::turn_inverted(reader, &mut elements, &nodes);
    let node_sets = boundary::read(reader);
    boundary::check_sets(reader, &nodes, node_sets.len());
    let cohesive_laws = joints::read(reader);
    let insertion = joints::insertion(reader, &materials, &elements);
    let contact = contact::read(reader, &materials);
    let face_pressures = faces::read(reader, &elements);
    let (probes, probe_threshold) = probes::read(reader, 3);
    let scene = Scene {
        name: name.to_owned(),
        conventions: Conventions::Y3D,
        control,
        nodes,
        elements,
        materials,
        cohesive_laws,
        node_sets,
        load_history: None,
        ramp: None,
        in_situ: None,
        fracture_network: None,
        seismic: SeismicMethod::SinceYield,
        initial_aperture: InitialAperture::default(),
        joint_restart: None,
        snapshots: None,
        joint_points: JointPoints::MidEdges,
        failed_joints: FailedJoints::Left,
        hysteretic_joints: false,
        face_pressures,
        pressure_ramp: reader.real("YDC/DCRMPT"),
        contact,
        insertion,
        probes,
        probe_threshold,
    };
    if !reader.has_errors() {
        materials::check_use(reader, &scene);
        elements::check_edges(reader, &scene);
        joints::check_use(reader, &scene);
        scene.check_shapes(reader);
        contact::check_use(reader, &scene);
        scene.check_places(reader);
    }
    Some(scene)
}
