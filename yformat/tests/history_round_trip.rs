//! Histories of all dialects are read; those of the split dialect come back byte for byte.

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use yformat::history::{History, HistoryError, HistoryPoint, HistoryWriter, LineStyle};

fn written(history: &History, style: LineStyle) -> Vec<u8> {
    let mut writer = HistoryWriter::new(Vec::new(), style);
    for point in &history.points {
        writer.write(point.time, point.value).unwrap();
    }
    writer.into_inner()
}

fn shared(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared").join(folder);
    let Ok(cases) = fs::read_dir(&folder) else {
        println!("skipped: no {}", folder.display());
        return Vec::new();
    };
    let mut files = Vec::new();
    for case in cases.map(|case| case.unwrap().path()).filter(|case| case.is_dir()) {
        let inside = fs::read_dir(case).unwrap().map(|entry| entry.unwrap().path());
        files.extend(inside.filter(|path| {
            let name = path.file_name().unwrap().to_string_lossy();
            name.rsplit_once(".yh").is_some_and(|(_, tail)| tail.parse::<u32>().is_ok())
        }));
    }
    files
}

#[test]
fn histories_of_the_split_dialect_come_back_byte_for_byte() {
    let files =
        [shared("reference/split2d"), shared("reference/split3d"), shared("thirdparty/masonry")]
            .concat();
    for path in files {
        let text = fs::read(&path).unwrap();
        let history = History::parse(&text).unwrap();
        let style = if text.contains(&b'\r') { LineStyle::Windows } else { LineStyle::Unix };
        assert!(written(&history, style) == text, "{}", path.display());
    }
}

#[test]
fn classic_histories_are_read() {
    for path in [shared("reference/classic"), shared("reference/ygeo")].concat() {
        let text = fs::read(&path).unwrap();
        let history = History::parse(&text);
        assert!(history.is_ok(), "{}: {history:?}", path.display());
    }
    let text = b"+0.000e+00 +1.388e+02\n +1.000e+00 -2.000e+00\n+3.800e-03 +1.318e+02\n +0.000e+00 +0.000e+00\n";
    let history = History::parse(text).unwrap();
    let times: Vec<f64> = history.points.iter().map(|p| p.time).collect();
    assert_eq!(times, [0.0, 3.8e-3]);
    assert_eq!(history.contact_forces, [[1.0, -2.0], [0.0, 0.0]]);
}

#[test]
fn odd_spellings_are_understood() {
    let text = b"+1.0e+00-2.0e-003\r\n\r\n+2e0 +nan\n+3.0 -1.#IND000000e+000\n+4 1.#QNAN00e+000\n+5 -nan(ind)\n+6 -inf\n7\t.5\n";
    let history = History::parse(text).unwrap();
    let points = &history.points;
    assert_eq!(points[0], HistoryPoint { time: 1.0, value: -2e-3 });
    assert!(points[1..5].iter().all(|p| p.value.is_nan()));
    assert_eq!(points[5].value, f64::NEG_INFINITY);
    assert_eq!(points[6], HistoryPoint { time: 7.0, value: 0.5 });
    assert!(!history.unterminated);
}

#[test]
fn a_cut_last_line_is_left_out() {
    let history = History::parse(b"+0.0e+00 +1.0e+00\n+1.0e+00 ").unwrap();
    assert_eq!(history.points.len(), 1);
    assert!(history.unterminated);
}

#[test]
fn what_is_no_history_is_refused_with_its_line() {
    for text in [&b"1 2\n1 2 3\n"[..], b"1 2\nx\n", b"1 2\n3\n", b"1 2\n\xff\xfe 1\n"] {
        let error = History::parse(text).unwrap_err();
        assert!(matches!(error, HistoryError::NotTwoNumbers { line: 2, .. }), "{error}");
    }
}

proptest! {
    #[test]
    fn written_values_come_back_to_eleven_digits(
        values in prop::collection::vec((prop::num::f64::NORMAL, prop::num::f64::NORMAL), 0..20),
        windows: bool,
    ) {
        let style = if windows { LineStyle::Windows } else { LineStyle::Unix };
        let points = values.iter().map(|&(time, value)| HistoryPoint { time, value });
        let history = History { points: points.collect(), ..History::default() };
        let text = written(&history, style);
        let read = History::parse(&text).unwrap();
        prop_assert_eq!(read.points.len(), values.len());
        for (point, (time, value)) in read.points.iter().zip(values) {
            // The largest values may round up out of range.
            prop_assert!(point.time.is_infinite() || (point.time / time - 1.0).abs() < 1e-10);
            prop_assert!(point.value.is_infinite() || (point.value / value - 1.0).abs() < 1e-10);
        }
        prop_assert_eq!(written(&read, style), text);
    }

    #[test]
    fn no_text_makes_it_panic(text in prop::collection::vec(any::<u8>(), 0..200)) {
        let _ = History::parse(&text);
    }

    #[test]
    fn no_almost_numbers_make_it_panic(text in "[-+0-9.eE#INFQDnaif() \n\r]{0,80}") {
        let _ = History::parse(text.as_bytes());
    }
}
