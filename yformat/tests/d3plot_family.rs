//! Families of several files: roll-over, names, sizes, temporary names.

use std::fs;
use std::path::Path;

use yformat::d3plot::{
    ControlBlock, Counts, FamilyReader, FamilyWriter, Geometry, NodeVectors, Notice, Shell,
    StartDate, StateView, Stresses, Title, WriteError, member_path, states_per_file,
};

const DATE: StartDate = StartDate { day: 27, month: 7, year: 2021 };

/// A strip of triangles with a state for every instant.
struct Scene {
    coordinates: Vec<[f32; 2]>,
    stresses: Vec<[f32; 3]>,
    materials: Vec<f32>,
}

impl Scene {
    fn new(nodes: u16, elements: u16) -> Self {
        Self {
            coordinates: (0..nodes).map(|n| [f32::from(n), 0.5]).collect(),
            stresses: (0..elements).map(|e| [f32::from(e), 1.0, 0.1]).collect(),
            materials: vec![1.0; usize::from(elements)],
        }
    }

    fn create(&self, path: &Path, states: u64) -> FamilyWriter {
        let counts =
            Counts { nodes: self.coordinates.len(), elements: self.stresses.len(), properties: 1 };
        let control = ControlBlock::two_dimensional(Title::new("strip", DATE), counts).unwrap();
        let geometry = Geometry {
            coordinates: vec![[0.0; 3]; counts.nodes],
            shells: vec![Shell::triangle([0, 1, 2], 1); counts.elements],
            ..Geometry::default()
        };
        FamilyWriter::create(path, control, &geometry, states).unwrap()
    }

    fn state(&self, time: f64) -> StateView<'_> {
        StateView {
            time,
            kinetic_energy: 2.0 * time,
            coordinates: NodeVectors::Plane(&self.coordinates),
            velocities: NodeVectors::Zero,
            accelerations: NodeVectors::Zero,
            stresses: Stresses::Plane(&self.stresses),
            deletion_table: &self.materials,
        }
    }
}

#[test]
fn files_roll_over_where_y_rolls_over() {
    // The deck x_family.y of the reference material: 441 nodes, 800 elements, 600 states.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x_family");
    let scene = Scene::new(441, 800);
    let mut writer = scene.create(&path, states_per_file(441, 800));
    for step in 0..600 {
        writer.write_state(&scene.state(f64::from(step))).unwrap();
    }
    let files = writer.finish().unwrap().files;
    let sizes: Vec<u64> = files.iter().map(|file| fs::metadata(file).unwrap().len()).collect();
    assert_eq!(sizes, [5_579_692, 5_558_144, 5_558_144, 5_558_144, 766_640]);
    let names: Vec<_> = files.iter().map(|f| f.file_name().unwrap()).collect();
    let expected = ["x_family", "x_family01", "x_family02", "x_family03", "x_family04"];
    assert_eq!(names, expected);
    let mut reader = FamilyReader::open(&path).unwrap();
    assert_eq!(reader.states_per_member(), [145, 145, 145, 145, 20]);
    assert_eq!(reader.notices(), []);
    for index in [0, 144, 145, 599] {
        let state = reader.state(index).unwrap();
        assert_eq!(state.time, index as f32);
        assert_eq!(state.globals[..2], [2.0 * index as f32, 0.0]);
        assert_eq!(state.coordinates[440], [440.0, 0.5, 0.0]);
        assert_eq!(state.shell_data[6 * 799..], [799.0, 1.0, 0.0, 0.1, 0.0, 0.0]);
    }
    assert!(reader.state(600).is_err());
}

#[test]
fn a_full_last_file_has_no_marker() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip");
    let scene = Scene::new(3, 1);
    let mut writer = scene.create(&path, 2);
    for step in 0..4 {
        writer.write_state(&scene.state(f64::from(step))).unwrap();
    }
    assert_eq!(writer.finish().unwrap().files.len(), 2);
    let marker = (-999_999.0_f32).to_le_bytes();
    assert!(fs::read(&path).unwrap().ends_with(&marker));
    assert!(!fs::read(folder.path().join("strip01")).unwrap().ends_with(&marker));
    assert_eq!(FamilyReader::open(&path).unwrap().times(), [0.0, 1.0, 2.0, 3.0]);
}

#[test]
fn names_go_on_after_99() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip");
    let scene = Scene::new(3, 1);
    let mut writer = scene.create(&path, 1);
    for step in 0..102 {
        writer.write_state(&scene.state(f64::from(step))).unwrap();
    }
    let files = writer.finish().unwrap().files;
    assert_eq!(files.last().unwrap(), &folder.path().join("strip101"));
    assert_eq!(FamilyReader::open(&path).unwrap().state_count(), 102);
}

#[test]
fn an_unfinished_file_keeps_its_temporary_name() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip");
    fs::write(&path, "an older result").unwrap();
    let scene = Scene::new(3, 1);
    let mut writer = scene.create(&path, 2);
    for step in 0..2 {
        writer.write_state(&scene.state(f64::from(step))).unwrap();
    }
    assert_eq!(fs::read(&path).unwrap(), b"an older result");
    writer.write_state(&scene.state(2.0)).unwrap();
    assert!(fs::read(&path).unwrap().len() > 256);
    drop(writer);
    let mut left: Vec<_> = fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    left.sort();
    assert_eq!(left, ["strip", "strip01.part"]);
    assert_eq!(FamilyReader::open(&path).unwrap().state_count(), 2);
}

#[test]
fn files_of_an_older_longer_family_are_reported() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip");
    let scene = Scene::new(3, 1);
    for states in [4, 1] {
        let mut writer = scene.create(&path, 1);
        for step in 0..states {
            writer.write_state(&scene.state(f64::from(step))).unwrap();
        }
        let finished = writer.finish().unwrap();
        let stale = if states == 1 { vec![1, 2, 3] } else { vec![] };
        let stale: Vec<_> = stale.into_iter().map(|i| member_path(&path, i)).collect();
        assert_eq!(finished.stale, stale);
    }
    let reader = FamilyReader::open(&path).unwrap();
    assert_eq!(reader.state_count(), 1);
    let path = member_path(&path, 1);
    assert_eq!(reader.notices(), [Notice::FollowerIgnored { path }]);
}

#[test]
fn a_state_of_the_wrong_size_is_refused_and_leaves_the_file_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("strip");
    let scene = Scene::new(3, 1);
    let mut writer = scene.create(&path, 10);
    let wrong = Scene::new(4, 1);
    let refused = writer.write_state(&wrong.state(0.0));
    assert!(matches!(
        refused,
        Err(WriteError::Length { array: "coordinates", expected: 3, found: 4 })
    ));
    writer.write_state(&scene.state(1.0)).unwrap();
    writer.finish().unwrap();
    assert_eq!(FamilyReader::open(&path).unwrap().times(), [1.0]);
}
