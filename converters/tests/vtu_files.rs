//! `.vtu` and `.pvd` files, seen from a reader's side.

mod vtu_decoder;

use std::fs;
use std::path::Path;

use ypsilon_converters::ConvertError;
use ypsilon_converters::vtk::{
    CellType, Components, DataArray, PvdSeries, UnstructuredGrid, Values, encode_vtu, write_vtu,
};

/// A triangle and a line with one array of every kind.
fn grid() -> UnstructuredGrid {
    let mut grid = UnstructuredGrid {
        points: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.1, 1.0 / 3.0, -2.0]],
        ..UnstructuredGrid::default()
    };
    grid.cells.push(CellType::Triangle, &[0, 1, 2]);
    grid.cells.push(CellType::Line, &[2, 0]);
    grid.point_data = vec![
        DataArray::plane_vector("velocity", &[[1.0, 2.0], [3.0, 4.0], [5.0, f64::NAN]]),
        DataArray::new("temperature", Components::Scalar, Values::Float32(vec![0.5, 1.5, 2.5])),
    ];
    grid.cell_data = vec![
        DataArray::symmetric_tensor("stress", vec![[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], [0.0; 6]]),
        DataArray::integer("material property ID", vec![7, -1]),
        DataArray::byte("broken <&> \"kept\"", vec![0, 1]),
        DataArray::new(
            "strengths",
            Components::Named(vec!["tensile".into(), "shear".into()]),
            Values::Int64(vec![1, 2, 3, 1 << 40]),
        ),
    ];
    grid.field_data = vec![DataArray::time(0.25), DataArray::scalar("energies", vec![1.0, 2.0])];
    grid
}

fn encoded(grid: &UnstructuredGrid) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode_vtu(&mut bytes, grid).unwrap();
    bytes
}

#[test]
fn the_arrays_come_back() {
    let vtu = vtu_decoder::decode(&encoded(&grid()));
    assert_eq!(vtu.attributes["header_type"], "UInt64");
    assert_eq!(vtu.attributes["NumberOfPoints"], "3");
    assert_eq!(vtu.attributes["NumberOfCells"], "2");
    let points = &vtu.array("Points", "Points").values;
    assert_eq!(points[..], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.1, 1.0 / 3.0, -2.0]);
    assert_eq!(vtu.array("Cells", "connectivity").values, [0.0, 1.0, 2.0, 2.0, 0.0]);
    assert_eq!(vtu.array("Cells", "offsets").values, [3.0, 5.0]);
    assert_eq!(vtu.array("Cells", "types").values, [5.0, 3.0]);
    let velocity = &vtu.array("PointData", "velocity").values;
    assert_eq!(velocity[..7], [1.0, 2.0, 0.0, 3.0, 4.0, 0.0, 5.0]);
    assert!(velocity[7].is_nan());
    assert_eq!(vtu.array("PointData", "temperature").values, [0.5, 1.5, 2.5]);
    let stress = vtu.array("CellData", "stress");
    assert_eq!(stress.values[..6], [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let names: Vec<_> = (0..6).map(|i| &stress.attributes[&format!("ComponentName{i}")]).collect();
    assert_eq!(names, ["XX", "YY", "ZZ", "XY", "YZ", "XZ"]);
    assert_eq!(vtu.array("CellData", "material property ID").values, [7.0, -1.0]);
    assert_eq!(vtu.array("CellData", "broken <&> \"kept\"").values, [0.0, 1.0]);
    let strengths = &vtu.array("CellData", "strengths").values;
    assert_eq!(strengths[..], [1.0, 2.0, 3.0, (1_u64 << 40) as f64]);
    assert_eq!(vtu.array("FieldData", "TimeValue").values, [0.25]);
    assert_eq!(vtu.array("FieldData", "energies").attributes["NumberOfTuples"], "2");
}

#[test]
fn the_header_reads_well() {
    insta::assert_snapshot!(vtu_decoder::decode(&encoded(&grid())).header);
}

#[test]
fn arrays_longer_than_the_encoding_buffer_are_whole() {
    let count = 5000;
    let grid = UnstructuredGrid {
        points: (0..count).map(|i| [f64::from(i), 0.5, -f64::from(i)]).collect(),
        point_data: vec![DataArray::integer("index", (0..count).collect())],
        ..UnstructuredGrid::default()
    };
    let vtu = vtu_decoder::decode(&encoded(&grid));
    assert_eq!(vtu.array("Points", "Points").values, grid.points.as_flattened());
    let index: Vec<f64> = (0..count).map(f64::from).collect();
    assert_eq!(vtu.array("PointData", "index").values, index);
}

#[test]
fn an_empty_grid_is_a_file_too() {
    let vtu = vtu_decoder::decode(&encoded(&UnstructuredGrid::default()));
    assert_eq!(vtu.attributes["NumberOfCells"], "0");
}

#[test]
fn arrays_of_the_wrong_length_are_refused() {
    let mut grid = grid();
    grid.cell_data.push(DataArray::scalar("short", vec![1.0]));
    let refused = encode_vtu(Vec::new(), &grid);
    let expected = ConvertError::ArrayLength { array: "short".into(), expected: 2, found: 1 };
    assert_eq!(refused.unwrap_err().to_string(), expected.to_string());
}

#[test]
fn files_replace_older_ones_and_leave_nothing_beside() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wall_0.vtu");
    fs::write(&path, "older").unwrap();
    write_vtu(&path, &grid()).unwrap();
    assert_eq!(fs::read(&path).unwrap(), encoded(&grid()));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt as _;
        let plain = folder.path().join("plain");
        fs::write(&plain, "").unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        assert_eq!(mode(&path), mode(&plain), "as readable as any new file");
    }
    let missing = folder.path().join("no such folder/wall.vtu");
    assert!(write_vtu(&missing, &grid()).is_err());
}

#[test]
fn a_collection_lists_times_parts_and_names() {
    let mut series = PvdSeries::new();
    series.push(0.0, 0, "triangles", "wall_0.vtu");
    series.push(0.0, 1, "joints", "wall_joints_0.vtu");
    series.push(2.5e-7, 0, "a <name> & more", "wall_10.vtu");
    let mut text = Vec::new();
    series.encode(&mut text).unwrap();
    insta::assert_snapshot!(String::from_utf8(text).unwrap());
}
