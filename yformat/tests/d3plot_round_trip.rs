//! Files that Y wrote, read and written again, give the same bytes.

use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use yformat::d3plot::{ControlBlock, Counts, FamilyReader, FamilyWriter, Notice, Shell, Solid};

fn committed() -> Vec<PathBuf> {
    files_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/d3plot"))
}

/// The shared reference material, where the checkout has it beside it.
fn shared() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared");
    let files = ["reference/split2d", "reference/split3d", "thirdparty"]
        .map(|sub| files_below(&folder.join(sub)))
        .concat();
    if files.is_empty() {
        println!("skipped: no reference files in {}", folder.display());
    }
    files
}

fn files_below(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut files = Vec::new();
    for path in entries.map(|entry| entry.unwrap().path()) {
        if path.is_dir() {
            files.extend(files_below(&path));
        } else if path.extension().is_some_and(|e| e == "d3plot") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// Reads the file and writes what was read; the bytes of both and how many of the file's end
/// belong to a cut state.
fn rewritten(path: &Path) -> (Vec<u8>, Vec<u8>, usize) {
    let mut reader = FamilyReader::open(path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let copy = folder.path().join("copy");
    let control = *reader.control();
    let mut writer = FamilyWriter::create(&copy, control, reader.geometry(), u64::MAX).unwrap();
    for index in 0..reader.state_count() {
        writer.copy_state(&reader.state(index).unwrap()).unwrap();
    }
    writer.finish().unwrap();
    let cut = match reader.notices() {
        [] => 0,
        [Notice::TruncatedState { bytes, .. }] => usize::try_from(*bytes).unwrap(),
        other => panic!("{}: {other:?}", path.display()),
    };
    (fs::read(path).unwrap(), fs::read(copy).unwrap(), cut)
}

fn assert_same_bytes(path: &Path) {
    let (original, copy, cut) = rewritten(path);
    let whole = original.len() - cut;
    assert!(original[..whole] == copy[..], "{}", path.display());
}

#[test]
fn committed_files_come_back_byte_for_byte() {
    let files = committed();
    assert_eq!(files.len(), 5);
    for path in files {
        assert_same_bytes(&path);
    }
}

#[test]
fn all_reference_files_come_back_byte_for_byte() {
    let mut truncated = 0;
    for path in shared() {
        assert_same_bytes(&path);
        let mut reader = FamilyReader::open(&path).unwrap();
        assert!(reader.state_count() > 0, "{}", path.display());
        reader.state(reader.state_count() - 1).unwrap();
        truncated += reader.notices().len();
    }
    // The only file that was cut is the one that says so in its name.
    assert!(truncated <= 1);
}

#[test]
fn a_control_block_made_from_counts_is_that_of_y() {
    for path in committed().into_iter().chain(shared()) {
        let reader = FamilyReader::open(&path).unwrap();
        let read = *reader.control();
        let geometry = reader.geometry();
        let counts = Counts {
            nodes: geometry.coordinates.len(),
            elements: geometry.shells.len() + geometry.solids.len(),
            properties: usize::try_from(read.nmmat).unwrap(),
        };
        let made = if read.nel8 > 0 {
            ControlBlock::three_dimensional(read.title, counts)
        } else {
            ControlBlock::two_dimensional(read.title, counts)
        };
        assert_eq!(made.unwrap().legacy(), read, "{}", path.display());
    }
}

/// Elements of a state file: property and nodes.
fn elements_of_state(text: &str) -> Vec<(i32, Vec<u32>)> {
    let at = text.find("# element").unwrap();
    text[at..]
        .lines()
        .filter(|line| !line.starts_with('#') && !line.trim().is_empty())
        .map(|line| {
            let mut numbers = line.split_whitespace().skip(1).map(|n| n.parse::<i32>().unwrap());
            let property = numbers.next().unwrap();
            (property, numbers.filter_map(|n| u32::try_from(n).ok()).collect())
        })
        .collect()
}

#[test]
fn element_constructors_give_the_connectivity_of_y() {
    let mut joints = 0;
    for path in shared() {
        let state = path.with_file_name("state_1.txt");
        // The masonry states were made with another build and are not needed here.
        let (Ok(text), false) = (fs::read_to_string(state), path.ends_with("actual.d3plot")) else {
            continue;
        };
        let reader = FamilyReader::open(&path).unwrap();
        let geometry = reader.geometry();
        let elements = elements_of_state(&text);
        let shells = elements.iter().filter(|(property, _)| *property >= 0);
        let solids = elements.iter().filter(|(property, _)| *property > -1000);
        for ((_, nodes), shell) in shells.zip(&geometry.shells) {
            let made = match nodes[..] {
                [a, b, c] => Shell::triangle([a, b, c], shell.material),
                [a, b, c, d] => {
                    joints += 1;
                    Shell::joint([a, b, c, d], shell.material)
                }
                _ => panic!("{}: {nodes:?}", path.display()),
            };
            assert_eq!(made, *shell, "{}", path.display());
        }
        for ((_, nodes), solid) in solids.zip(&geometry.solids) {
            let made = match nodes[..] {
                [a, b, c, d] => Solid::tetrahedron([a, b, c, d], solid.material),
                [a, b, c, d, e, f] => {
                    joints += 1;
                    Solid::joint([a, b, c, d, e, f], solid.material)
                }
                _ => panic!("{}: {nodes:?}", path.display()),
            };
            assert_eq!(made, *solid, "{}", path.display());
        }
    }
    println!("{joints} joints compared");
}

#[test]
fn a_cut_file_keeps_its_whole_states() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/d3plot/a_gravxy.d3plot");
    let bytes = fs::read(path).unwrap();
    let record = 4 * (1 + 13 + 9 * 3 + 7);
    let data = bytes.len() - 4 * record;
    for length in data..bytes.len() {
        let mut reader = FamilyReader::from_sources([Cursor::new(&bytes[..length])]).unwrap();
        let whole = (length - data) / record;
        assert_eq!(reader.state_count(), whole);
        assert_eq!(reader.notices().len(), usize::from(!(length - data).is_multiple_of(record)));
        assert!(reader.state(whole).is_err());
    }
    for length in 0..data {
        assert!(FamilyReader::from_sources([Cursor::new(&bytes[..length])]).is_err());
    }
}

/// A family that is left at any state, with or without its last file complete, and gone on with
/// there is the family of a writer that never stopped.
#[test]
fn a_family_is_gone_on_with() {
    let path = committed().into_iter().next().expect("a committed family");
    let mut reader = FamilyReader::open(&path).expect("a family");
    let control = *reader.control();
    let geometry = reader.geometry().clone();
    let state = reader.state(0).expect("a state");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let files = |name: &str| -> Vec<(String, Vec<u8>)> {
        let mut files = Vec::new();
        for entry in fs::read_dir(folder.path().join(name)).expect("a folder").flatten() {
            let path = entry.path();
            let name = path.file_name().expect("a name").to_string_lossy().into_owned();
            files.push((name, fs::read(path).expect("a file")));
        }
        files.sort();
        files
    };
    let begin = |name: &str| {
        fs::create_dir(folder.path().join(name)).expect("a folder");
        let path = folder.path().join(name).join("wall");
        let writer = FamilyWriter::create(&path, control, &geometry, 3).expect("a family");
        (path, writer)
    };
    let (_, mut straight) = begin("straight");
    (0..8).for_each(|_| straight.copy_state(&state).expect("a state"));
    straight.finish().expect("complete");
    assert_eq!(files("straight").len(), 3);
    for stop in 0..8 {
        for is_killed in [false, true] {
            let name = format!("{stop}{is_killed}");
            let (path, mut writer) = begin(&name);
            (0..stop).for_each(|_| writer.copy_state(&state).expect("a state"));
            let mark = writer.mark().expect("a mark");
            // and further than the mark
            (stop..7).for_each(|_| writer.copy_state(&state).expect("a state"));
            match is_killed {
                true => drop(writer),
                false => drop(writer.finish().expect("complete")),
            }
            let mut writer = FamilyWriter::resume(&path, 3, &mark).expect("a family to go on with");
            (stop..8).for_each(|_| writer.copy_state(&state).expect("a state"));
            assert_eq!(writer.finish().expect("complete").files.len(), 3);
            assert!(files(&name) == files("straight"), "stopped after {stop}");
        }
    }
    let (path, mut writer) = begin("other");
    let mark = writer.mark().expect("a mark");
    drop(writer);
    fs::write(path.with_file_name("wall.part"), b"something else").expect("writable");
    assert!(FamilyWriter::resume(&path, 3, &mark).is_err());
}
