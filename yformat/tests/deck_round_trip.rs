//! Reading and writing lose nothing: real decks byte for byte, made decks bit for bit.

use std::path::{Path, PathBuf};

use proptest::prelude::*;
use yformat::database::Database;
use yformat::deck::{Deck, DeckBuilder, DeckReader, ItemKind};
use yformat::dialect::Dialect;
use yformat::source::SourceId;

/// All decks of the folder shared by the makers of Ypsilon, if it is there.
fn shared_decks() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared");
    let mut decks = Vec::new();
    let mut folders = vec![root];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = std::fs::read_dir(&folder) else { continue };
        for path in entries.flatten().map(|entry| entry.path()) {
            let extension = path.extension().and_then(|extension| extension.to_str());
            match extension {
                _ if path.is_dir() => folders.push(path),
                Some("y" | "Y3D") => decks.push(path),
                _ => {}
            }
        }
    }
    decks.sort();
    decks
}

#[test]
fn every_shared_deck_is_written_back_byte_for_byte() {
    let decks = shared_decks();
    if decks.is_empty() {
        println!("skipped: no shared decks beside this checkout");
    }
    for path in decks {
        let bytes = std::fs::read(&path).expect("listed file");
        let outcome = Deck::read(&path).expect("listed file");
        assert!(outcome.deck.to_bytes() == bytes, "{} is changed", path.display());
        if std::env::var_os("SHOW_DIAGNOSTICS").is_some() {
            println!("{} is {}", path.display(), outcome.deck.dialect());
            outcome.diagnostics.iter().for_each(|found| println!("    {found}"));
            let mut database = Database::new(outcome.deck.dialect());
            (0..outcome.deck.items().len())
                .flat_map(|item| database.apply(&outcome.deck, item))
                .for_each(|found| println!("    {found}"));
        }
    }
}

/// Decks that the original programs run, and the one kind of deck that they write and cannot read.
#[test]
fn every_shared_reference_deck_is_read_without_error() {
    for path in shared_decks() {
        let shown = path.display().to_string();
        if shown.contains("/probes/") {
            continue;
        }
        let outcome = Deck::read(&path).expect("listed file");
        if let Some(error) = outcome.error() {
            panic!("{shown}\n{}", error.render(outcome.deck.sources()));
        }
        // The checkout's own path may hold any of these words.
        let inside = shown.rsplit_once("/shared/").map_or(shown.as_str(), |(_, inside)| inside);
        let expected = match inside {
            _ if inside.ends_with(".Y3D") => Dialect::Y3d,
            _ if inside.contains("ygeo") => Dialect::YGeo,
            _ if inside.contains("classic") || inside.contains("acse") => Dialect::Classic,
            _ => Dialect::Split,
        };
        assert_eq!(outcome.deck.dialect(), expected, "{shown}");
        let mut database = Database::new(expected);
        for item in 0..outcome.deck.items().len() {
            for found in database.apply(&outcome.deck, item) {
                assert!(!found.is_error(), "{}", found.render(outcome.deck.sources()));
            }
        }
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("decks hold finite numbers", |value| value.is_finite())
}

/// Text made of pieces that matter to the grammar, so that most of it is read and not only refused.
fn deck_text() -> impl Strategy<Value = String> {
    let piece = prop_oneof![
        Just("/YD/YDC/MCSTEP 5".to_owned()),
        Just("/YD/YDC/MCSTEPS".to_owned()),
        Just("/* a comment */".to_owned()),
        Just("/*x*/ swallowed */".to_owned()),
        Just("$YDOIT".to_owned()),
        Just("$YSTOP".to_owned()),
        Just("/YD/YDPE/MPROP 4 /YD/YDPE/D1PERO 3".to_owned()),
        Just("/YD/YDN/D2NCC 21 2 2".to_owned()),
        Just("/YD/YDPN/D3PNFAC 231 2 1 2".to_owned()),
        any::<f32>().prop_map(|number| number.to_string()),
        any::<i32>().prop_map(|number| number.to_string()),
        "[ -~]{0,12}",
    ];
    let space = prop_oneof![Just(" "), Just("\n"), Just("\r\n"), Just("\t "), Just("")];
    proptest::collection::vec((piece, space), 0..30)
        .prop_map(|pieces| pieces.into_iter().map(|(piece, space)| piece + space).collect())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_text_is_written_back_as_it_was(text in deck_text(), forced in 0usize..5) {
        let dialect = Dialect::ALL.get(forced).copied();
        let outcome = DeckReader::new().dialect(dialect).parse("a.y", text.clone());
        prop_assert_eq!(outcome.deck.to_text(), text);
    }

    #[test]
    fn included_files_are_written_back_too(main in deck_text(), included in deck_text()) {
        let text = format!("$YINCL b.y\n{main}");
        let mut reader = DeckReader::new().dialect(Dialect::Split).includes(|_: &str| Ok(included.clone().into_bytes()));
        let outcome = reader.parse("a.y", text.clone());
        prop_assert_eq!(outcome.deck.to_text(), text);
        let file = outcome.deck.items().iter().map(|item| item.file()).find(|file| file.index() == 1);
        let written = file.map(|file: SourceId| outcome.deck.file_to_bytes(file)).unwrap_or_default();
        prop_assert_eq!(written, included.as_bytes());
    }

    #[test]
    fn values_survive_writing_and_reading_bit_for_bit(
        step in any::<i64>(),
        gravity in finite(),
        densities in proptest::collection::vec(finite(), 0..20),
        nodes in proptest::collection::vec((finite(), finite()), 0..20),
        factors in proptest::collection::vec((finite(), finite()), 0..6),
        types in proptest::collection::vec(any::<i64>(), 0..20),
        comment in ".{0,400}",
    ) {
        let coordinates: Vec<f64> = nodes.iter().flat_map(|&(x, y)| [x, y]).collect();
        let table: Vec<f64> = factors.iter().flat_map(|&(time, factor)| [time, factor]).collect();
        let deck = DeckBuilder::new(Dialect::Split)
            .comment(comment)
            .integer("YDC/MCSTEP", step)
            .real("YDC/DCGRAY", gravity)
            .integer("YDPE/MPROP", 20)
            .reals("YDPE/D1PERO", densities.clone())
            .integers("YDPE/I1PTYP", types.clone())
            .integer("YDN/MNODIM", 2)
            .integer("YDN/MNOPO", 20)
            .reals2("YDN/D2NCI", 2, coordinates)
            .integer("YDPN/MPNSET", 1)
            .integer("YDPN/MPNFACT", 6)
            .reals3("YDPN/D3PNFAC", [2, 1, factors.len()], table)
            .run()
            .stop()
            .build();
        let text = deck.to_bytes();
        let outcome = DeckReader::new().dialect(Dialect::Split).parse("a.y", text);
        prop_assert!(outcome.diagnostics.is_empty(), "{:?}", outcome.diagnostics);
        let again = outcome.deck;
        prop_assert_eq!(again.items().iter().filter(|item| item.kind() == &ItemKind::Run).count(), 1);
        let mut database = Database::new(Dialect::Split);
        for item in 0..again.items().len() {
            prop_assert_eq!(database.apply(&again, item), vec![]);
        }
        prop_assert_eq!(database.integer("YDC/MCSTEP"), step);
        prop_assert_eq!(database.real("YDC/DCGRAY").to_bits(), gravity.to_bits());
        let density = database.reals("YDPE/D1PERO").unwrap();
        prop_assert!(densities.iter().enumerate().all(|(i, value)| density.get1(i).to_bits() == value.to_bits()));
        let kind = database.integers("YDPE/I1PTYP").unwrap();
        prop_assert!(types.iter().enumerate().all(|(i, value)| kind.get1(i) == *value));
        let initial = database.reals("YDN/D2NCI").unwrap();
        prop_assert!(nodes.iter().enumerate().all(|(j, node)| initial.get2(0, j).to_bits() == node.0.to_bits()));
        prop_assert!(nodes.iter().enumerate().all(|(j, node)| initial.get2(1, j).to_bits() == node.1.to_bits()));
        let factor = database.reals("YDPN/D3PNFAC").unwrap();
        prop_assert!(factors.iter().enumerate().all(|(k, at)| factor.get3(1, 0, k).to_bits() == at.1.to_bits()));
    }
}

#[test]
fn changes_leave_the_rest_alone() {
    let text =
        "/* head */\n/YD/YDC/MCSTEP 5/* glued */\r\n  /YD/YDPE/MPROP 1 $YDOIT\n$YSTOP\nnotes";
    let read = || Deck::parse("a.y", text).deck;
    let mut replaced = read();
    let more = replaced.scalar("YDC/MCSTEP", 9.0).expect("known keyword");
    assert!(replaced.replace(1, more.clone()));
    let expected =
        "/* head */\n/YD/YDC/MCSTEP 9\n/* glued */\r\n  /YD/YDPE/MPROP 1 $YDOIT\n$YSTOP\nnotes";
    assert_eq!(replaced.to_text(), expected);
    let mut inserted = read();
    inserted.insert(0, more.clone());
    assert_eq!(inserted.to_text(), format!("/YD/YDC/MCSTEP 9\n{text}"));
    let mut inserted = read();
    inserted.insert(4, more);
    let expected = text.replace(" $YDOIT", "\n/YD/YDC/MCSTEP 9 $YDOIT");
    assert_eq!(inserted.to_text(), expected);
    let mut removed = read();
    assert!(removed.remove(2).is_some());
    assert_eq!(removed.to_text(), text.replace("/* glued */", ""));
}

#[test]
fn bytes_of_old_code_pages_are_kept() {
    let bytes = b"/* \xe9quilibre \xb2 */ /YD/YDC/MCSTEP 5 $YDOIT\n".to_vec();
    let deck = Deck::parse("a.y", bytes.clone()).deck;
    assert_eq!(deck.to_bytes(), bytes);
    assert!(deck.to_text().starts_with("/* équilibre ² */"));
}
