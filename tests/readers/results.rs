//! Result files: what `convert`, `plot` and `extract` read.

use super::folder;
use std::{fs, io::Cursor, path::Path};
use yformat::{d3plot::FamilyReader, history::History, ym::Snapshot};
use ypsilon_converters::{
    d3plot::{DeletedElements, d3plot_to_vtu},
    detect::detect_file,
    history::histories_to_csv,
    vtk::{decode_pvd, decode_vtu},
    vtk_series::{SeriesForm, series_of, series_to_pvd},
    ym::ym_to_vtu,
};
use ypsilon_post::{
    extract::Locator,
    results::{Results, bounds},
    selection::Selection,
    table::Table,
};

/// A deck that says by what the values of a snapshot were divided.
const SCALES: &[u8] =
    b"/YD/YDC/DCSIZS 1e6\n/YD/YDC/DCSIZD 1e-3\n/YD/YDC/DCSIZA 1e-7\n/YD/YDC/DCSIZV 10.0\n";

/// The file of a d3plot family: alone, and as one that a second file continues.
pub fn d3plot(bytes: &[u8]) {
    let halves = bytes.split_at(bytes.len() / 2 / 4 * 4);
    for files in [vec![bytes], vec![halves.0, halves.1]] {
        let Ok(mut family) = FamilyReader::from_sources(files.into_iter().map(Cursor::new)) else {
            continue;
        };
        for index in 0..family.state_count().min(4) {
            let _ = family.state(index);
        }
    }
    with_file("run", bytes, |path, folder| {
        let _ = d3plot_to_vtu(path, folder, "run", DeletedElements::Drop, |_, _| ());
        frames(path);
    });
}

/// A `.ym` snapshot, with a deck beside it.
pub fn ym(bytes: &[u8]) {
    if Snapshot::parse("run4.ym", bytes).is_ok() {
        with_file("run4.ym", bytes, |path, folder| {
            let deck = folder.join("run.y");
            fs::write(&deck, SCALES).expect("a writable folder");
            let _ = ym_to_vtu(path, Some(&deck), folder, "run", |_, _| ());
        });
    }
}

/// A `.yh` history.
pub fn history(bytes: &[u8]) {
    if History::parse(bytes).is_ok() {
        with_file("run.yh0", bytes, |path, folder| {
            let _ = histories_to_csv(&[path], &folder.join("run.csv"));
        });
    }
}

/// A VTK file of Y-Geo, once as triangles and once as points.
pub fn vtp(bytes: &[u8]) {
    for name in ["wall.y_0.vtp", "wall.y_acoustic_0.vtu"] {
        with_file(name, bytes, |path, folder| {
            let out = folder.join("out");
            fs::create_dir(&out).expect("a writable folder");
            if let Ok(series) = series_of(path) {
                let _ = series_to_pvd(&series, &out, SeriesForm::Copy, |_, _| ());
            }
        });
    }
}

/// A VTU file, by itself and as one time of a series.
pub fn vtu(bytes: &[u8]) {
    if decode_vtu(bytes).is_ok() {
        with_file("run.vtu", bytes, |path, _| frames(path));
    }
}

/// A PVD collection.
pub fn pvd(bytes: &[u8]) {
    if decode_pvd(bytes).is_ok() {
        with_file("run.pvd", bytes, |path, _| frames(path));
    }
}

/// A table of comma-separated values.
pub fn csv(bytes: &[u8]) {
    if let Ok(text) = std::str::from_utf8(bytes)
        && let Ok(table) = Table::parse(text)
    {
        let written = table.to_csv();
        assert!(Table::parse(&written).is_ok(), "{written}");
    }
}

/// The first times of results.
fn frames(path: &Path) {
    let Ok(mut results) = Results::open(path) else { return };
    for index in 0..results.len().min(2) {
        if let Ok(frame) = results.frame(index) {
            let _ = frame.energy();
            let _ = bounds(&frame.initial());
        }
        if let Ok(frame) = results.frame_in::<3, 4>(index) {
            let _ = frame.energy();
            let initial = frame.initial();
            let _ = Selection::All.nodes(&frame.mesh(&initial));
            let _ = Locator::new(&frame.elements, &initial).find([0.1; 3]);
        }
    }
}

/// Calls a reader with a file in a folder of its own.
fn with_file(name: &str, bytes: &[u8], read: impl FnOnce(&Path, &Path)) {
    let folder = folder();
    let path = folder.path().join(name);
    fs::write(&path, bytes).expect("a writable folder");
    let _ = detect_file(&path);
    read(&path, folder.path());
}
