//! Gmsh meshes to decks. The files in `data/gmsh` were written by Gmsh 4.15.2.

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use yformat::database::Database;
use yformat::deck::Deck;
use ypsilon_converters::ConvertError;
use ypsilon_converters::gmsh::{GmshError, gmsh_to_deck, parse_msh, skeleton};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gmsh").join(name)
}

fn text(name: &str) -> Vec<u8> {
    fs::read(data(name)).unwrap()
}

/// The deck's text, its values and the warnings.
fn converted(name: &str) -> (String, Database, Vec<String>) {
    converted_text(&text(name))
}

fn converted_text(text: &[u8]) -> (String, Database, Vec<String>) {
    let made = skeleton(&parse_msh(text).unwrap(), "mesh.msh").unwrap();
    let outcome = Deck::parse("deck.y", made.deck.to_text());
    assert!(outcome.diagnostics.is_empty(), "{:?}", outcome.diagnostics);
    let deck = outcome.deck;
    assert_eq!(deck.stages().iter().filter(|stage| stage.runs).count(), 1);
    let mut database = Database::new(deck.dialect());
    for item in 0..deck.items().len() {
        let findings = database.apply(&deck, item);
        assert!(findings.is_empty(), "{findings:?}");
    }
    (deck.to_text(), database, made.warnings)
}

fn integers(database: &Database, name: &str, count: usize) -> Vec<i64> {
    let field = database.integers(name).unwrap();
    (0..count).map(|index| field.get1(index)).collect()
}

/// Areas of the triangles with their element sets.
fn areas(database: &Database) -> Vec<(i64, f64)> {
    let corners = database.integers("YDE/I2ELTO").unwrap();
    let points = database.reals("YDN/D2NCI").unwrap();
    let sets = database.integers("YDE/I1ELPR").unwrap();
    let point = |node: i64| [0, 1].map(|axis| points.get2(axis, node as usize));
    (0..database.integer("YDE/NELEM") as usize)
        .map(|e| {
            let [a, b, c] = [0, 1, 2].map(|corner| point(corners.get2(corner, e)));
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            (sets.get1(e), 0.5 * area)
        })
        .collect()
}

#[test]
fn physical_groups_become_sets_in_both_versions() {
    for name in ["wall_22.msh", "wall_41.msh", "wall_saveall_41.msh"] {
        let (text, database, warnings) = converted(name);
        assert_eq!(database.integer("YDPE/NPROP"), 2, "{name}");
        for comment in [
            "/* Element set 0: right stone (physical surface 3) */",
            "/* Element set 1: left stone (physical surface 7) */",
            "/* Node set 1: fixed base (physical curve 11), fixed */",
            "/* Node set 2: top load (physical curve 12), free */",
            "/* Node set 3: corner (physical point 13), free */",
        ] {
            assert!(text.contains(comment), "{name}: {comment}");
        }
        let areas = areas(&database);
        for set in [0, 1] {
            let of_set = areas.iter().filter(|(of, _)| *of == set);
            let total: f64 = of_set.map(|(_, area)| area).sum();
            assert!((total - 1.0).abs() < 1e-12, "{name}: set {set} has the area {total}");
        }
        assert!(areas.iter().all(|&(_, area)| area > 0.0), "{name}: counter-clockwise");
        assert_eq!(integers(&database, "YDPN/I1PNFX", 4), [1, 3, 1, 1]);
        let nodes = database.integer("YDN/NNOPO") as usize;
        let points = database.reals("YDN/D2NCI").unwrap();
        for (node, set) in integers(&database, "YDN/I1NOPR", nodes).into_iter().enumerate() {
            let [x, y] = [0, 1].map(|axis| points.get2(axis, node));
            let expected = match y {
                1.0 if x == 2.0 => 3,
                1.0 => 2,
                0.0 => 1,
                _ => 0,
            };
            assert_eq!(set, expected, "{name}: node at {x} {y}");
            let inside = x > 0.0 && x < 2.0 && y > 0.0 && y < 1.0;
            let flag = database.integers("YDN/I1NOBF").unwrap().get1(node);
            assert_eq!(flag, i64::from(!inside), "{name}: flag at {x} {y}");
        }
        assert_eq!(warnings.len(), 1, "{name}: {warnings:?}");
        assert!(warnings[0].starts_with("nodes in several physical groups"));
    }
}

#[test]
fn both_versions_of_a_mesh_make_the_same_deck() {
    assert_eq!(converted("wall_22.msh").0, converted("wall_41.msh").0);
}

#[test]
fn a_mesh_without_groups_is_one_free_body() {
    let (text, database, warnings) = converted("plain_22.msh");
    assert!(text.contains("/* Element set 0: triangles of no physical surface */"));
    assert_eq!(database.integer("YDPE/NPROP"), 1);
    assert_eq!(database.integer("YDPN/NPNSET"), 1);
    assert!(warnings.is_empty(), "{warnings:?}");
    // The smallest height of the triangles and the wave speed of the placeholder concrete.
    let speed = (20e9_f64 * 0.8 / (1.2 * 0.6) / 2400.0).sqrt();
    let step = database.real("YDC/DCSTEC");
    assert!(step * speed > 0.09 * 0.3 && step * speed < 0.11 * 0.5, "{step}");
}

/// A square of two triangles, version 2.2, with more elements behind.
fn square(more: &[&str]) -> Vec<u8> {
    let nodes = "5\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n9 5 5 0\n";
    let elements = [&["1 2 2 5 1 1 3 2", "2 2 2 5 1 1 3 4"], more].concat();
    format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{nodes}$EndNodes\n$Elements\n{}\n{}\n\
         $EndElements\n",
        elements.len(),
        elements.join("\n")
    )
    .into_bytes()
}

#[test]
fn clockwise_triangles_are_turned_and_unused_nodes_dropped() {
    let (_, database, warnings) = converted_text(&square(&[]));
    assert_eq!(areas(&database), [(0, 0.5), (0, 0.5)]);
    assert_eq!(database.integer("YDN/NNOPO"), 4);
    assert_eq!(warnings, ["nodes that belong to no triangle are left out: 1 of them"]);
}

#[test]
fn an_element_in_two_groups_is_taken_once() {
    let (_, database, warnings) = converted_text(&square(&["1 2 2 6 1 1 3 2"]));
    assert_eq!(areas(&database), [(1, 0.5), (0, 0.5)]);
    assert!(warnings.iter().any(|w| w.contains("several physical surfaces")), "{warnings:?}");
}

#[test]
fn elements_of_no_group_are_the_last_set() {
    let (_, database, _) = converted_text(&square(&["3 2 2 0 1 3 9 4"]));
    let sets: Vec<i64> = areas(&database).into_iter().map(|(set, _)| set).collect();
    assert_eq!(sets, [0, 0, 1]);
}

#[test]
fn quadrangles_are_cut_along_the_better_diagonal() {
    // An arrow head: only the diagonal through the inner corner gives two triangles inside it.
    let text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 2 1 0\n3 0 2 0\n\
                4 0.5 1 0\n$EndNodes\n$Elements\n1\n1 3 2 0 1 1 2 3 4\n$EndElements\n";
    let (_, database, _) = converted_text(text.as_bytes());
    assert_eq!(areas(&database), [(0, 0.75), (0, 0.75)]);
}

#[test]
fn what_cannot_be_a_deck_is_refused_with_a_remedy() {
    let said = |bytes: &[u8]| {
        let error = match parse_msh(bytes) {
            Err(error) => error,
            Ok(mesh) => skeleton(&mesh, "mesh.msh").unwrap_err(),
        };
        error.to_string()
    };
    for (bytes, words) in [
        (text("second_41.msh"), "an element of higher order"),
        (text("box_22.msh"), "a solid element"),
        (text("wall_41_binary.msh"), "binary"),
        (text("wall_40.msh"), "`4`"),
        (b"$MeshFormat\n".to_vec(), "version ``"),
        (b"/YD/YDC/MCSTEP 3".to_vec(), "no Gmsh mesh"),
        (square(&["3 2 2 0 1 1 2 77"]), "element 3 names node 77"),
        (square(&["3 2 2 0 1 1 2 2"]), "element 3 has no area"),
        (square(&["3 2 2 0 1 1 2"]), "`$EndElements`"),
    ] {
        let said = said(&bytes);
        assert!(said.contains(words), "{said}\ninstead of\n{words}");
    }
    let lifted = String::from_utf8(square(&[])).unwrap().replace("3 1 1 0", "3 1 1 0.5");
    assert!(said(lifted.as_bytes()).contains("z = 0.5"), "{}", said(lifted.as_bytes()));
    let twice = String::from_utf8(square(&[])).unwrap().replace("9 5 5 0", "1 5 5 0");
    assert_eq!(said(twice.as_bytes()), "node 1 is given twice");
}

#[test]
fn a_count_beyond_the_file_is_an_error_with_its_line() {
    let text = String::from_utf8(square(&[])).unwrap();
    let nodes = text.replace("$Nodes\n5\n", "$Nodes\n9000000000000000000\n");
    assert_eq!(
        parse_msh(nodes.as_bytes()).unwrap_err(),
        GmshError::Unexpected {
            line: 11,
            found: "`$EndNodes`".to_owned(),
            expected: "a node number"
        }
    );
    let negative = text.replace("$Nodes\n5\n", "$Nodes\n-5\n");
    assert!(matches!(parse_msh(negative.as_bytes()), Err(GmshError::Unexpected { line: 5, .. })));
}

#[test]
fn cut_files_are_errors_and_leave_no_deck() {
    let folder = tempfile::tempdir().unwrap();
    let whole = text("wall_41.msh");
    let (input, output) = (folder.path().join("cut.msh"), folder.path().join("cut.y"));
    for length in (0..whole.len() - "EndElements\n".len()).step_by(7) {
        fs::write(&input, &whole[..length]).unwrap();
        let result = gmsh_to_deck(&input, &output);
        assert!(matches!(result, Err(ConvertError::Gmsh { .. })), "{length}: {result:?}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{length}");
    }
    fs::write(&input, whole).unwrap();
    assert_eq!(gmsh_to_deck(&input, &output).unwrap().len(), 1);
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 2);
}

proptest! {
    /// Whatever word of a mesh is replaced by whatever other: a deck that can be read, or an
    /// error, but no panic.
    #[test]
    fn no_mesh_makes_it_panic(
        version in 0..2_usize,
        changes in prop::collection::vec((any::<prop::sample::Index>(), "-?[0-9]{1,19}|[0-9.e-]{1,8}|\\$[A-Za-z]{1,12}|nan|1e308|0|2|3"), 1..4),
    ) {
        let text = String::from_utf8(text(["wall_22.msh", "wall_41.msh"][version])).unwrap();
        let mut words: Vec<&str> = text.split_inclusive(char::is_whitespace).collect();
        let replaced: Vec<String> = changes.iter().map(|(_, word)| format!("{word} ")).collect();
        for ((index, _), word) in changes.iter().zip(&replaced) {
            let at = index.index(words.len());
            words[at] = word;
        }
        let mesh = parse_msh(words.concat().as_bytes());
        if let Ok(made) = mesh.and_then(|mesh| skeleton(&mesh, "mesh.msh")) {
            let outcome = Deck::parse("deck.y", made.deck.to_text());
            prop_assert!(outcome.diagnostics.is_empty(), "{:?}", outcome.diagnostics);
        }
    }
}
