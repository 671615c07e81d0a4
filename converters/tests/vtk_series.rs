//! The VTK files of Y-Geo to time series. The files in `data/ygeo` are those of the original.

mod vtu_decoder;

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use tempfile::TempDir;
use ypsilon_converters::ConvertError;
use ypsilon_converters::vtk_series::{SeriesForm, SeriesReport, series_of, series_to_pvd};

fn data() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/ygeo")
}

/// A copy of the files, to be spoilt.
fn copy() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for entry in fs::read_dir(data()).unwrap() {
        let path = entry.unwrap().path();
        fs::copy(&path, folder.path().join(path.file_name().unwrap())).unwrap();
    }
    folder
}

fn convert(from: &Path, to: &Path, form: SeriesForm) -> Result<SeriesReport, ConvertError> {
    let series = series_of(&from.join("g_joint_pair.y_acoustic_0.vtu"))?;
    assert_eq!(series.family, "g_joint_pair.y");
    let mut told = Vec::new();
    let report = series_to_pvd(&series, to, form, |done, all| told.push((done, all)))?;
    assert_eq!(told.last(), Some(&(series.files.len(), series.files.len())));
    Ok(report)
}

#[test]
fn any_file_of_a_run_leads_to_all() {
    let folder = copy();
    let out = folder.path().join("out");
    fs::create_dir(&out).unwrap();
    let report = convert(folder.path(), &out, SeriesForm::Link).unwrap();
    assert!(report.has_times && report.broken.is_empty());
    assert_eq!((report.files, &report.collection), (14, &out.join("g_joint_pair.y.pvd")));
    let text = fs::read_to_string(&report.collection).unwrap();
    let lines: Vec<&str> = text.lines().filter(|line| line.contains("<DataSet")).collect();
    // Step 1500 of 2e-6 s, after all files of step 0.
    assert!(lines[..7].iter().all(|line| line.contains("timestep=\"0.0\"")), "{text}");
    assert!(lines[7..].iter().all(|line| line.contains("timestep=\"0.003\"")), "{text}");
    assert!(lines[0].contains("part=\"0\" name=\"elements\" file=\"../g_joint_pair.y_0.vtp\""));
    for (part, line) in lines.iter().enumerate() {
        assert!(line.contains(&format!("part=\"{}\"", part % 7)), "{line}");
        let file = line.split("file=\"").nth(1).unwrap().split('"').next().unwrap();
        assert!(out.join(file).is_file(), "{file}");
    }
}

#[test]
fn copies_say_the_same_and_show_points() {
    let out = tempfile::tempdir().unwrap();
    let report = convert(&data(), out.path(), SeriesForm::Copy).unwrap();
    assert_eq!((report.files, report.broken.len()), (14, 0));
    let read = |name: &str| vtu_decoder::decode(&fs::read(out.path().join(name)).unwrap());
    let triangles = read("g_joint_pair.y_1500.vtu");
    assert_eq!(triangles.array("FieldData", "TimeValue").values, [0.003]);
    assert_eq!(triangles.array("Cells", "connectivity").values, [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]);
    assert_eq!(triangles.array("Cells", "types").values, [5.0, 5.0]);
    assert_eq!(triangles.array("CellData", "stress").values.len(), 18);
    assert_eq!(triangles.array("PointData", "velocity").values.len(), 18);
    // The text of the original, value by value.
    let text = fs::read_to_string(data().join("g_joint_pair.y_1500.vtp")).unwrap();
    let words = text.split("Name='velocity'").nth(1).unwrap().lines().nth(1).unwrap();
    let values: Vec<f64> =
        words.split_whitespace().map(|w| f64::from(w.parse::<f32>().unwrap())).collect();
    assert_eq!(triangles.array("PointData", "velocity").values, values);
    let directions = read("g_joint_pair.y_principal_direction_0.vtu");
    assert_eq!(directions.array("Cells", "types").values, [1.0, 1.0]);
    let broken = read("g_joint_pair.y_broken_joints_1500.vtu");
    assert_eq!(broken.array("Cells", "types").values, [9.0; 10]);
    assert_eq!(read("g_joint_pair.y_rebars_0.vtu").attributes["NumberOfPoints"], "0");
}

#[test]
fn without_a_deck_the_times_are_step_numbers() {
    let folder = copy();
    fs::remove_file(folder.path().join("g_joint_pair.y")).unwrap();
    let report = convert(folder.path(), folder.path(), SeriesForm::Link).unwrap();
    assert!(!report.has_times);
    let text = fs::read_to_string(&report.collection).unwrap();
    assert!(text.contains("timestep=\"1500.0\"") && text.contains("file=\"g_joint_pair.y_0.vtp\""));
}

#[test]
fn files_that_are_cut_short_are_left_out_and_named() {
    let folder = copy();
    let cut = folder.path().join("g_joint_pair.y_1500.vtp");
    let whole = fs::read(&cut).unwrap();
    fs::write(&cut, &whole[..whole.len() - 20]).unwrap();
    for form in [SeriesForm::Link, SeriesForm::Copy] {
        let out = tempfile::tempdir().unwrap();
        let report = convert(folder.path(), out.path(), form).unwrap();
        assert_eq!((report.files, report.broken.len()), (13, 1));
        let said = report.broken[0].to_string();
        assert!(said.contains("g_joint_pair.y_1500.vtp") && said.contains("cut short"), "{said}");
    }
}

#[test]
fn wrong_values_are_named() {
    let folder = copy();
    let path = folder.path().join("g_joint_pair.y_0.vtp");
    let whole = fs::read_to_string(&path).unwrap();
    for (old, new, words) in [
        ("0 1 2 3 4 5", "0 1 2 3 4 6", "point 6; points run from 0 to 5"),
        ("0 1 2 3 4 5", "0 1 2 3 4", "ends at 6"),
        ("0 1 2 3 4 5", "0 1 2 3 x 5", "`x`"),
        ("</Points>", "</Pints>", "byte"),
        (
            "Name='velocity' NumberOfComponents='3'",
            "Name='velocity' NumberOfComponents='2'",
            "velocity",
        ),
        ("format='ascii'", "format='binary'", "expected ascii"),
    ] {
        assert!(whole.contains(old), "{old}");
        fs::write(&path, whole.replace(old, new)).unwrap();
        let out = tempfile::tempdir().unwrap();
        let said = match convert(folder.path(), out.path(), SeriesForm::Copy) {
            Ok(report) => report.broken[0].to_string(),
            Err(error) => error.to_string(),
        };
        assert!(said.contains(words), "{said}\ninstead of\n{words}");
        assert!(!out.path().join("g_joint_pair.y_0.vtu").exists());
    }
}

#[test]
fn a_name_without_a_step_is_an_error() {
    let said = series_of(Path::new("wall.vtp")).unwrap_err().to_string();
    assert!(said.contains("wall.vtp") && said.contains("wall.y_300.vtp"), "{said}");
}

proptest! {
    #[test]
    fn no_file_makes_it_panic(at in any::<prop::sample::Index>(), bytes in prop::collection::vec(any::<u8>(), 0..6)) {
        let folder = tempfile::tempdir().unwrap();
        let name = "g_joint_pair.y_broken_joints_1500.vtp";
        let mut text = fs::read(data().join(name)).unwrap();
        let begin = at.index(text.len());
        let end = (begin + bytes.len()).min(text.len());
        text.splice(begin..end, bytes);
        fs::write(folder.path().join(name), text).unwrap();
        let series = series_of(&folder.path().join(name)).unwrap();
        let _ = series_to_pvd(&series, folder.path(), SeriesForm::Copy, |_, _| {});
    }
}
