//! `ypsilon plot`: pictures of results and curves.

mod support;

use assert_cmd::Command;
use std::{fs, path::Path};
use support::{
    plate_deck::{Case, plate},
    results::results,
};

/// Exit code and messages of the program.
fn plot(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    let command = command.current_dir(folder).arg("plot").args(arguments);
    let output = command.output().expect("the program starts");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

fn drawn(folder: &Path, arguments: &[&str], picture: &str) -> Vec<u8> {
    let mut all = arguments.to_vec();
    all.extend(["-o", picture]);
    let (code, told) = plot(folder, &all);
    assert_eq!(code, Some(0), "{arguments:?}: {told}");
    fs::read(folder.join(picture)).expect("a picture")
}

/// Width, height and pixels (red, green, blue, opacity) of a PNG file of 8 bits.
fn pixels(png: &[u8]) -> (usize, usize, Vec<u8>) {
    assert_eq!(&png[..8], b"\x89PNG\r\n\x1a\n");
    let word = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()) as usize;
    let (width, height) = (word(16), word(20));
    assert_eq!(png[24..26], [8, 6], "8 bits of red, green, blue, opacity");
    let (mut at, mut packed) = (8, Vec::new());
    while at + 8 < png.len() {
        if &png[at + 4..at + 8] == b"IDAT" {
            packed.extend_from_slice(&png[at + 8..at + 8 + word(at)]);
        }
        at += 12 + word(at);
    }
    let mut raw = Vec::new();
    let mut reader = flate2::read::ZlibDecoder::new(packed.as_slice());
    std::io::Read::read_to_end(&mut reader, &mut raw).expect("packed pixels");
    let row = 4 * width;
    assert_eq!(raw.len(), height * (row + 1));
    let mut pixels = vec![0_u8; height * row];
    for y in 0..height {
        let filter = raw[y * (row + 1)];
        for i in 0..row {
            let value = raw[y * (row + 1) + 1 + i];
            let left = if i >= 4 { pixels[y * row + i - 4] } else { 0 };
            let up = if y > 0 { pixels[(y - 1) * row + i] } else { 0 };
            let corner = if y > 0 && i >= 4 { pixels[(y - 1) * row + i - 4] } else { 0 };
            let guess = match filter {
                0 => 0,
                1 => left,
                2 => up,
                3 => u8::midpoint(left, up),
                4 => {
                    let p = i32::from(left) + i32::from(up) - i32::from(corner);
                    let far = |v: u8| (p - i32::from(v)).abs();
                    let nearest = [left, up, corner].into_iter().min_by_key(|v| far(*v));
                    nearest.unwrap_or(0)
                }
                other => panic!("filter {other}"),
            };
            pixels[y * row + i] = value.wrapping_add(guess);
        }
    }
    (width, height, pixels)
}

#[test]
fn a_small_contour_picture_looks_as_it_did() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let arguments = ["plate.pvd", "--field", "syy", "--width", "400", "--title", "Plate & load"];
    let svg = drawn(folder.path(), &arguments, "plate.svg");
    insta::assert_snapshot!("plate", String::from_utf8(svg).expect("text"));
}

#[test]
fn png_pictures_have_the_size_and_the_colours_asked_for() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let arguments = ["plate.pvd", "--field", "ux", "--width", "640", "--range=-0.01:0.01"];
    let png = drawn(folder.path(), &arguments, "plate.png");
    let (width, height, pixels) = pixels(&png);
    assert_eq!(width, 640);
    assert!((500..700).contains(&height), "{height}");
    assert_eq!(&pixels[..4], [255; 4], "paper");
    // ux is small against the range: near the middle of blue and red
    let centre = 4 * (width * (height / 2) + width / 2 - 60);
    let [r, g, b] = [0, 1, 2].map(|k| i32::from(pixels[centre + k]));
    assert!((r - 225).abs() < 25 && (g - 218).abs() < 15 && (b - 215).abs() < 35, "{r} {g} {b}");
    assert!(pixels.chunks(4).any(|p| p[..3] == [0x22, 0x22, 0x22]), "ink of frame and text");
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let folder = results(&plate(Case::Loaded, 300), &[], 1);
    for extra in [&["--smooth", "--robust"][..], &["--edges", "--undeformed", "--scale", "100"]] {
        for ending in ["png", "svg"] {
            let mut arguments = vec!["plate.pvd", "--field", "s1"];
            arguments.extend(extra);
            let first = drawn(folder.path(), &arguments, &format!("first.{ending}"));
            let second = drawn(folder.path(), &arguments, &format!("second.{ending}"));
            assert!(first == second, "{extra:?} {ending}");
        }
    }
}

#[test]
fn curves_are_drawn_from_tables_and_histories() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    let table = "uy (m),reaction y (N),reaction x (N)\n0,0,0\n-0.001,50000,10\n-0.004,80000,nan\n";
    fs::write(folder.path().join("push.csv"), table).expect("a table");
    let history = "+0.0e+00 +1.0e+00\n+1.0e-03 +2.0e+00\n";
    fs::write(folder.path().join("plate.yh0"), history).expect("a history");
    let arguments = ["push.csv", "--x-factor=-1", "--width", "400", "--height", "300"];
    let svg = drawn(folder.path(), &arguments, "push.svg");
    insta::assert_snapshot!("push", String::from_utf8(svg).expect("text"));
    let arguments = ["plate.yh0", "--width", "500", "--height", "300", "--markers"];
    let (width, height, _) = pixels(&drawn(folder.path(), &arguments, "history.png"));
    assert_eq!((width, height), (500, 300));
}

#[test]
fn axes_can_be_logarithmic() {
    let folder = tempfile::TempDir::new().expect("a folder");
    let table = "time (s),error\n1e-4,1e-1\n1e-3,1e-3\n1e-2,0\n1e-1,1e-7\n";
    fs::write(folder.path().join("errors.csv"), table).expect("a table");
    let arguments = ["errors.csv", "--log", "x,y", "--markers"];
    let svg = String::from_utf8(drawn(folder.path(), &arguments, "errors.svg")).expect("text");
    for label in ["10⁻³", "10⁻²", "10⁻⁶"] {
        assert!(svg.contains(&format!(">{label}<")), "{label}: {svg}");
    }
    // zero has no logarithm
    let linear = String::from_utf8(drawn(folder.path(), &["errors.csv"], "linear.svg"));
    assert!(!linear.expect("text").contains("10⁻³"));
}

#[test]
fn what_cannot_be_drawn_is_told() {
    let folder = results(&plate(Case::LinearDisplacement, 2), &[], 1);
    fs::write(folder.path().join("bad.csv"), "a,b\n1,x\n").expect("a table");
    for (arguments, expected_code, message) in [
        (&["plate.pvd", "-o", "p.gif"][..], 2, "p.gif`: expected .png or .svg"),
        (&["plate.pvd", "-o", "p.png", "--field", "heat"], 2, "the field `heat`: there are"),
        (&["plate.pvd", "-o", "p.png", "--field", "damage"], 1, "hold no damage of triangles"),
        (&["plate.pvd", "-o", "p.png", "--range", "5:1"], 2, "the smaller number first"),
        (&["plate.pvd", "-o", "p.png", "--range", "5"], 2, "expected LOW:HIGH"),
        (&["plate.pvd", "-o", "p.png", "--robust", "60"], 2, "expected 0 to less than 50"),
        (&["plate.pvd", "-o", "p.png", "--width", "10"], 2, "expected 300 to 8000 pixels"),
        (&["plate.pvd", "-o", "p.png", "--window", "1:0,0:1"], 2, "the window"),
        (&["plate.pvd", "-o", "p.png", "--time", "#9"], 1, "states are #0 to #1"),
        (&["plate", "-o", "p.png", "--field", "f"], 1, "hold no nodal forces"),
        (&["none.pvd", "-o", "p.png"], 1, "none.pvd"),
        (&["bad.csv", "-o", "p.png"], 1, "line 2 holds `x`; expected a number"),
        (&["plate.pvd", "-o", "nowhere/p.png"], 3, "nowhere/p.png"),
    ] {
        let (code, told) = plot(folder.path(), arguments);
        assert_eq!(code, Some(expected_code), "{arguments:?}: {told}");
        assert!(told.contains(message), "{arguments:?}: {told}");
    }
    assert!(!folder.path().join("p.png").exists());
}
