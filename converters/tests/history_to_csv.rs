//! Histories to CSV.

use std::fs;

use ypsilon_converters::ConvertError;
use ypsilon_converters::history::histories_to_csv;

/// The table made from files with these names and texts.
fn table(files: &[(&str, &str)]) -> Result<String, ConvertError> {
    let folder = tempfile::tempdir().unwrap();
    let paths: Vec<_> = files
        .iter()
        .map(|(name, text)| {
            let path = folder.path().join(name);
            fs::write(&path, text).unwrap();
            path
        })
        .collect();
    let inputs: Vec<_> = paths.iter().map(|path| path.as_path()).collect();
    let output = folder.path().join("out.csv");
    let report = histories_to_csv(&inputs, &output)?;
    let csv = fs::read_to_string(output).unwrap();
    assert_eq!(csv.lines().count(), report.rows + 1);
    Ok(csv)
}

#[test]
fn one_history_keeps_its_order() {
    let text =
        "+0.0000000000e+000 +0.0000000000e+000\r\n+5.0e-004 +1.1768e+001\r\n+0.0e+00 +nan\r\n";
    let csv = table(&[("wall.yh0", text)]).unwrap();
    assert_eq!(csv, "time,wall.yh0\n0.0,0.0\n0.0005,11.768\n0.0,NaN\n");
}

#[test]
fn histories_of_the_same_times_share_rows() {
    let csv = table(&[("a,b.yh0", "+0 +1\n+1 +2\n"), ("a.yh1", "+0 +3\n+1 +4\n")]).unwrap();
    assert_eq!(csv, "time,\"a,b.yh0\",a.yh1\n0.0,1.0,3.0\n1.0,2.0,4.0\n");
}

#[test]
fn histories_of_other_times_leave_cells_empty() {
    let csv = table(&[("a", "+0 +1\n+2 +2\n"), ("b", "+1 +3\n+2 +4\n")]).unwrap();
    assert_eq!(csv, "time,a,b\n0.0,1.0,\n1.0,,3.0\n2.0,2.0,4.0\n");
}

#[test]
fn classic_histories_show_contact_forces() {
    let csv = table(&[("a", "+0 +1\n +2 +3\n+1 +4\n +5 +6\n")]).unwrap();
    let expected = "time,a,contact force x,contact force y\n0.0,1.0,2.0,3.0\n1.0,4.0,5.0,6.0\n";
    assert_eq!(csv, expected);
}

#[test]
fn what_is_no_history_is_named() {
    let error = table(&[("deck.y", "/YD/YDC/MCSTEP 600\n")]).unwrap_err().to_string();
    assert!(error.contains("deck.y: line 1 is not a time and a value"), "{error}");
}
