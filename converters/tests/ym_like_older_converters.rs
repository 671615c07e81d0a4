//! What the older converters `m2vtu` and `m2vtu_crack` made of published snapshots, against what is
//! made here. The files are not part of the repository; without them the test says so.

mod legacy_vtu;
mod vtu_decoder;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use vtu_decoder::Vtu;
use ypsilon_converters::ym::ym_to_vtu;

fn published() -> PathBuf {
    let shared = match std::env::var_os("YPSILON_SHARED") {
        Some(folder) => PathBuf::from(folder),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared"),
    };
    shared.join("thirdparty/acse/test")
}

/// Rows of an array.
fn rows<const N: usize>(values: &[f64]) -> Vec<[f64; N]> {
    assert_eq!(values.len() % N, 0);
    values.chunks_exact(N).map(|row| row.try_into().unwrap()).collect()
}

fn ours<const N: usize>(vtu: &Vtu, name: &str) -> Vec<[f64; N]> {
    rows(&vtu.array("CellData", name).values)
}

/// The older converter gives triangles four equal points: the first row of each four.
fn of_triangles<const N: usize>(older: &BTreeMap<String, Vec<f64>>, name: &str) -> Vec<[f64; N]> {
    let all = rows::<N>(&older[name]);
    for four in all.chunks_exact(4) {
        assert!(four.iter().all(|row| row == &four[0]), "{name}");
    }
    all.into_iter().step_by(4).collect()
}

fn compare_triangles(vtu: &Vtu, older: &BTreeMap<String, Vec<f64>>) -> usize {
    let triangles = of_triangles::<3>(older, "Velocity vector").len();
    let corners: Vec<[f64; 3]> =
        rows::<3>(&older["Points"]).chunks_exact(4).flat_map(|four| four[..3].to_vec()).collect();
    let points = rows::<3>(&vtu.array("Points", "Points").values);
    let single = |row: [f64; 3]| row.map(|x| f64::from(x as f32));
    assert_eq!(points.into_iter().map(single).collect::<Vec<_>>(), corners);
    let connectivity: Vec<f64> = (0..3 * triangles).map(|point| point as f64).collect();
    assert_eq!(vtu.array("Cells", "connectivity").values, connectivity);
    assert!(vtu.array("Cells", "types").values.iter().all(|&kind| kind == 5.0));

    // Mend: tension is positive, six components for nine.
    let stresses: Vec<[f64; 9]> = ours::<6>(vtu, "Cauchy stress")
        .into_iter()
        .map(|[xx, yy, zz, xy, ..]| [-xx, -xy, 0.0, -xy, -yy, 0.0, 0.0, 0.0, zz])
        .collect();
    assert_eq!(stresses, of_triangles::<9>(older, "Stress tensor"));
    for (name, theirs) in
        [("velocity", "Velocity vector"), ("contact force", "Contact force vectors")]
    {
        assert_eq!(ours::<3>(vtu, name), of_triangles::<3>(older, theirs), "{name}");
    }
    for (name, theirs) in [
        ("sigma1 (compression positive)", "Sigma1"),
        ("sigma3 (compression positive)", "Sigma3"),
        ("mean stress (compression positive)", "Mean stress"),
        ("differential stress", "Differential stress"),
    ] {
        assert_eq!(ours::<1>(vtu, name), of_triangles::<1>(older, theirs), "{name}");
    }
    for (name, theirs) in [
        ("sigma1 vector (compression positive)", "Sigma1 Vectors"),
        ("sigma3 vector (compression positive)", "Sigma3 vectors"),
    ] {
        let theirs = of_triangles::<3>(older, theirs);
        for (a, b) in ours::<3>(vtu, name).into_iter().zip(theirs) {
            let apart = |sign: f64| (0..3).map(|k| (a[k] - sign * b[k]).abs()).fold(0.0, f64::max);
            let size = b.iter().map(|x| x * x).sum::<f64>().sqrt();
            // Their iteration is right to rounding only.
            assert!(apart(1.0).min(apart(-1.0)) <= 1e-14 * size, "{name}: {a:?} {b:?}");
        }
    }
    // points 3, stress 9, two vectors, four scalars, two principal vectors
    triangles * (9 + 9 + 6 + 4 + 6)
}

fn compare_cracks(vtu: &Vtu, older: &BTreeMap<String, Vec<f64>>) -> usize {
    // Mend: the deck has two sets of joints, and the older converter shows all joints twice.
    let lines = older["Failure mode"].len() / 2;
    let once = lines / 2;
    let first = |name: &str, components: usize| -> Vec<f64> {
        let all = &older[name];
        let (first, second) = all.split_at(all.len() / 2);
        assert_eq!(first, second, "{name} is given twice");
        let rows = first.chunks_exact(components);
        // Both ends of a line have the same values.
        rows.step_by(2).flat_map(<[f64]>::to_vec).collect()
    };
    let points: Vec<f64> = older["Points"][..6 * once].to_vec();
    let found = vtu.array("Points", "Points").values.iter().map(|&x| f64::from(x as f32));
    assert_eq!(found.collect::<Vec<_>>(), points);
    assert_eq!(vtu.attributes["NumberOfCells"], once.to_string());
    for (name, theirs) in [
        ("legacy shear displacement", "Shear displacement"),
        ("failure mode", "Failure mode"),
        ("fracture type", "Fracture type"),
    ] {
        assert_eq!(vtu.array("CellData", name).values, first(theirs, 1), "{name}");
    }
    assert_eq!(vtu.array("CellData", "contact force").values, first("Contact force", 3));
    once * (6 + 3 + 3)
}

#[test]
fn arrays_are_those_of_the_older_converters() {
    let folder = published();
    let input = folder.join("test1.ym");
    if !input.exists() {
        println!("skipped: {} is not there", input.display());
        return;
    }
    let output = tempfile::tempdir().unwrap();
    let report = ym_to_vtu(&input, None, output.path(), "wall", |_, _| {}).unwrap();
    assert_eq!(report.deck, Some(folder.join("test.y")));
    assert_eq!(report.notices, []);
    let (mut files, mut numbers) = (0, 0);
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let Some(stem) = name.strip_suffix(".vtu") else { continue };
        let older = legacy_vtu::decode(&std::fs::read_to_string(&path).unwrap());
        let crack = stem.strip_prefix("test_crack");
        let number = crack.or(stem.strip_prefix("test")).unwrap();
        let infix = if crack.is_some() { "_cracks" } else { "" };
        let ours = output.path().join(format!("wall{infix}_{number}.vtu"));
        let vtu = vtu_decoder::decode(&std::fs::read(ours).unwrap());
        numbers += match crack {
            Some(_) => compare_cracks(&vtu, &older),
            None => compare_triangles(&vtu, &older),
        };
        // Snapshot k is written after step 10 k, time steps are 1e-6 s.
        let time = vtu.array("FieldData", "TimeValue").values[0];
        let expected = (10.0 * number.parse::<f64>().unwrap() + 1.0) * 1e-6;
        assert!((time - expected).abs() < 1e-15, "{time} {expected}");
        files += 1;
    }
    assert!(files >= 16, "{files}");
    println!("{numbers} numbers of {files} published files agree");
}
