//! Files are recognised by content.

use std::fs;
use std::path::Path;

use ypsilon_converters::detect::{FileKind, detect, detect_file};

#[test]
fn d3plot_families_are_recognised() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../yformat/tests/data/d3plot");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        assert_eq!(detect_file(&path).unwrap(), FileKind::D3plot, "{}", path.display());
    }
}

#[test]
fn histories_are_recognised() {
    for text in [
        "+0.0000000000e+000 +0.0000000000e+000\r\n",
        "+0.000e+00 +1.388e+02\n +0.000e+00 +0.000e+00\n",
        "+0.0e+00-1.0e+00",
    ] {
        assert_eq!(detect(text.as_bytes()), FileKind::History, "{text}");
    }
}

#[test]
fn texts_are_told_apart() {
    let deck = "/* a deck */\n/YD/YDC/MCSTEP 600\n".repeat(50);
    assert_eq!(detect(deck.as_bytes()), FileKind::Deck);
    assert_eq!(detect(b"$MeshFormat\n2.2 0 8\n"), FileKind::Gmsh);
    let vtk =
        "<?xml version='1.0'?>\n<VTKFile type='PolyData' version='0.1' byte_order='x'><PolyData>";
    assert_eq!(detect(vtk.as_bytes()), FileKind::VtkSeries);
}

#[test]
fn other_files_are_unknown() {
    let ours = b"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">";
    for bytes in [&b""[..], b"\n", b"time,value\n", b"/* /YD/", ours, &[0; 256], &[0xff; 256]] {
        assert_eq!(detect(bytes), FileKind::Unknown);
    }
    assert!(detect_file(Path::new("no such file")).is_err());
}
