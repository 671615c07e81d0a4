//! d3plot families to `.vtu` series.

mod vtu_decoder;

use std::fs;
use std::path::Path;

use yformat::d3plot::{
    ControlBlock, Counts, FamilyReader, FamilyWriter, Geometry, NodeVectors, Shell, Solid,
    StartDate, StateView, Stresses, Title,
};
use ypsilon_converters::ConvertError;
use ypsilon_converters::d3plot::{DeletedElements, d3plot_to_vtu};

fn title() -> Title {
    let date = StartDate { day: 1, month: 2, year: 2025 };
    Title::new("pair", date)
}

/// Two triangles and a joint between them that breaks in the second state.
fn write_pair(path: &Path) {
    let counts = Counts { nodes: 6, elements: 3, properties: 2 };
    let control = ControlBlock::two_dimensional(title(), counts).unwrap();
    let start = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let geometry = Geometry {
        coordinates: start.map(|[x, y]: [f32; 2]| [x, y, 0.0]).to_vec(),
        shells: vec![
            Shell::triangle([0, 1, 2], 1),
            Shell::triangle([3, 4, 5], 2),
            Shell::joint([1, 2, 5, 3], 1),
        ],
        ..Geometry::default()
    };
    let mut writer = FamilyWriter::create(path, control, &geometry, 1).unwrap();
    for (time, alive) in [(0.0, 1.0), (0.5, 0.0)] {
        let moved = start.map(|[x, y]| [x + time as f32, y]);
        writer
            .write_state(&StateView {
                time,
                kinetic_energy: 3.0,
                coordinates: NodeVectors::Plane(&moved),
                velocities: NodeVectors::Plane(&[[1.0, 2.0]; 6]),
                accelerations: NodeVectors::Zero,
                stresses: Stresses::Plane(&[[3.0, -1.0, 0.0], [0.0, 0.0, 2.0], [0.0; 3]]),
                deletion_table: &[1.0, 2.0, alive],
            })
            .unwrap();
    }
    writer.finish().unwrap();
}

fn convert(input: &Path, folder: &Path, deleted: DeletedElements) -> usize {
    let mut told = Vec::new();
    let done = |done, all| told.push((done, all));
    let report = d3plot_to_vtu(input, folder, "pair", deleted, done).unwrap();
    assert_eq!(told.len(), report.states);
    assert_eq!(report.collection, folder.join("pair.pvd"));
    report.grids
}

#[test]
fn a_plane_family_becomes_triangles_and_joints() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("d3");
    write_pair(&input);
    assert_eq!(convert(&input, folder.path(), DeletedElements::Drop), 4);
    let read = |name: &str| vtu_decoder::decode(&fs::read(folder.path().join(name)).unwrap());
    let second = read("pair_1.vtu");
    assert_eq!(second.array("FieldData", "TimeValue").values, [0.5]);
    assert_eq!(second.array("FieldData", "kinetic energy").values, [3.0]);
    assert_eq!(second.array("Points", "Points").values[..3], [0.5, 0.0, 0.0]);
    let displacement = &second.array("PointData", "displacement").values;
    assert_eq!(displacement[15..], [0.5, 0.0, 0.0]);
    assert_eq!(second.array("PointData", "velocity").values[..3], [1.0, 2.0, 0.0]);
    assert_eq!(second.array("Cells", "types").values, [5.0, 5.0]);
    let connectivity = &second.array("Cells", "connectivity").values;
    assert_eq!(connectivity[..], [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    let property = &second.array("CellData", "material property ID").values;
    assert_eq!(property[..], [0.0, 1.0]);
    let stress = &second.array("CellData", "Cauchy stress").values;
    assert_eq!(stress[6..], [0.0, 0.0, 0.0, 2.0, 0.0, 0.0]);
    let mises = &second.array("CellData", "von Mises stress").values;
    assert!((mises[0] - 13.0_f64.sqrt()).abs() < 1e-14);
    assert!((mises[1] - 12.0_f64.sqrt()).abs() < 1e-14);
    for (array, values) in [
        ("principal stress 1", [3.0, 2.0]),
        ("principal stress 2", [0.0, 0.0]),
        ("principal stress 3", [-1.0, -2.0]),
        ("Tresca stress", [4.0, 4.0]),
    ] {
        assert_eq!(second.array("CellData", array).values, values);
    }
    let joints = read("pair_joints_0.vtu");
    assert_eq!(joints.array("Cells", "types").values, [9.0]);
    assert_eq!(joints.array("Cells", "connectivity").values, [1.0, 3.0, 5.0, 2.0]);
    assert_eq!(read("pair_joints_1.vtu").attributes["NumberOfCells"], "0");
    insta::assert_snapshot!(fs::read_to_string(folder.path().join("pair.pvd")).unwrap());
}

#[test]
fn broken_joints_can_be_flagged_instead() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("d3");
    write_pair(&input);
    convert(&input, folder.path(), DeletedElements::Flag);
    for (name, deleted) in [("pair_joints_0.vtu", 0.0), ("pair_joints_1.vtu", 1.0)] {
        let vtu = vtu_decoder::decode(&fs::read(folder.path().join(name)).unwrap());
        assert_eq!(vtu.array("CellData", "deleted").values, [deleted]);
    }
}

#[test]
fn a_spatial_family_becomes_tetrahedra_and_wedges() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("d3");
    let counts = Counts { nodes: 8, elements: 3, properties: 1 };
    let control = ControlBlock::three_dimensional(title(), counts).unwrap();
    let geometry = Geometry {
        coordinates: vec![[0.0; 3]; 8],
        solids: vec![
            Solid::tetrahedron([0, 1, 2, 3], 1),
            Solid::joint([0, 1, 2, 4, 5, 6], 1),
            Solid { nodes: [1, 2, 3, 4, 5, 6, 7, 8], material: 1 },
        ],
        ..Geometry::default()
    };
    let mut writer = FamilyWriter::create(&input, control, &geometry, 10).unwrap();
    let forces = [[1.0, 2.0, 3.0]; 8];
    writer
        .write_state(&StateView {
            time: 0.0,
            kinetic_energy: 0.0,
            coordinates: NodeVectors::Spatial(&[[0.5; 3]; 8]),
            velocities: NodeVectors::Zero,
            accelerations: NodeVectors::Spatial(&forces),
            stresses: Stresses::Spatial(&[[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]; 3]),
            deletion_table: &[1.0; 3],
        })
        .unwrap();
    writer.finish().unwrap();
    assert_eq!(FamilyReader::open(&input).unwrap().state(0).unwrap().solid_data[6], 0.0);
    convert(&input, folder.path(), DeletedElements::Drop);
    let read = |name: &str| vtu_decoder::decode(&fs::read(folder.path().join(name)).unwrap());
    let solids = read("pair_0.vtu");
    assert_eq!(solids.array("Cells", "types").values, [10.0, 12.0]);
    assert_eq!(solids.array("Cells", "offsets").values, [4.0, 12.0]);
    assert_eq!(solids.array("PointData", "joint force").values[..3], [1.0, 2.0, 3.0]);
    assert_eq!(
        solids.array("CellData", "Cauchy stress").values[6..],
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    );
    let joints = read("pair_joints_0.vtu");
    assert_eq!(joints.array("Cells", "types").values, [13.0]);
    let connectivity = &joints.array("Cells", "connectivity").values;
    assert_eq!(connectivity[..], [0.0, 1.0, 2.0, 4.0, 5.0, 6.0]);
}

#[test]
fn an_element_with_a_node_that_does_not_exist_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("d3");
    write_pair(&input);
    for node in [0_i32, 7, -1, i32::MIN, i32::MAX] {
        let mut bytes = fs::read(&input).unwrap();
        let first_shell = 256 + 12 * 6;
        bytes[first_shell..first_shell + 4].copy_from_slice(&node.to_le_bytes());
        let damaged = folder.path().join("damaged");
        fs::write(&damaged, bytes).unwrap();
        let result = d3plot_to_vtu(&damaged, folder.path(), "x", DeletedElements::Drop, |_, _| {});
        assert!(matches!(
            result,
            Err(ConvertError::NoSuchNode { element: 1, nodes: 6, node: found }) if found == node
        ));
    }
}
