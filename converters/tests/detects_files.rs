//! Files are recognised by content.

use std::fs;
use std::path::Path;

use ypsilon_converters::detect::{FileKind, detect, detect_file, is_deck, is_ym};

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
fn decks_are_recognised() {
    let long = "/* a deck */\n/YD/YDC/MCSTEP 600\n".repeat(50);
    let late = format!("/* {} */\r\n\t/YD/YDPE/MPROP 1", "comment ".repeat(90));
    for text in [long.as_str(), &late, "$YINCL mesh.y\n", "  $YDOIT"] {
        assert!(is_deck(text.as_bytes()), "{text}");
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../yformat/tests/data/classic");
    let restart = folder.join("g_joint_pair4_restart.y");
    assert!(is_deck(&fs::read(restart).unwrap()));
}

#[test]
fn snapshots_are_recognised() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../yformat/tests/data/classic");
    assert!(is_ym(&fs::read(folder.join("g_joint_pair4.ym")).unwrap()));
    for text in [&b"CODED"[..], b"CODED\r\n"] {
        assert!(is_ym(text));
        assert_eq!(detect(text), FileKind::Ym);
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
    let texts = [&b""[..], b"\n", b"time,value\n", b"/* /YD/", b"CODEDX\n", ours];
    for bytes in texts.into_iter().chain([&[0; 256][..], &[0xff; 256]]) {
        assert_eq!(detect(bytes), FileKind::Unknown);
        assert!(!is_ym(bytes) && !is_deck(bytes));
    }
    assert!(detect_file(Path::new("no such file")).is_err());
}
