//! Decks from one dialect to another: values, losses, errors.

use std::fs;
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use yformat::database::Database;
use yformat::deck::{Deck, DeckReader};
use yformat::dialect::Dialect;
use ypsilon_converters::ConvertError;
use ypsilon_converters::dialects::{ConvertedDeck, DialectError, convert_deck, deck_to_dialect};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/data").join(name)
}

fn text(name: &str) -> String {
    fs::read_to_string(data(name)).unwrap()
}

const CLASSIC: &str = "converted/classic/h_bc_ramp/h_bc_ramp.y";
const YGEO: &str = "converted/ygeo/g_joint_pair/g_joint_pair.y";
const SPLIT: &str = "split2d/e3_mixed/e3_mixed.y";

fn parse(text: &str) -> Deck {
    let outcome = Deck::parse("deck.y", text);
    let errors: Vec<_> = outcome.diagnostics.iter().filter(|found| found.is_error()).collect();
    assert!(errors.is_empty(), "{errors:?}");
    outcome.deck
}

/// The deck converted, its values as its own dialect reads them, and what got lost.
fn converted(text: &str, to: Dialect) -> (String, Database, Vec<String>) {
    let ConvertedDeck { deck, lost } = convert_deck(&parse(text), to).unwrap();
    let text = deck.to_text();
    let again = parse(&text);
    assert_eq!(again.dialect(), to);
    let mut database = Database::new(to);
    for item in 0..again.items().len() {
        let found = database.apply(&again, item);
        assert!(found.is_empty(), "{found:?}");
    }
    (text, database, lost)
}

fn reals(database: &Database, name: &str, count: usize) -> Vec<f64> {
    let field = database.reals(name).unwrap();
    (0..count).map(|index| field.get1(index)).collect()
}

fn integers(database: &Database, name: &str, count: usize) -> Vec<i64> {
    let field = database.integers(name).unwrap();
    (0..count).map(|index| field.get1(index)).collect()
}

/// A deck with the value behind a keyword replaced.
fn edited(text: &str, edits: &[(&str, &str)]) -> String {
    let mut text = text.to_owned();
    for (old, new) in edits {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    text
}

/// Asserts that one of the sentences holds these words.
fn assert_told(lost: &[String], words: &str) {
    assert!(lost.iter().any(|line| line.contains(words)), "{words}\nnot in\n{lost:#?}");
}

#[test]
fn the_common_table_of_classic_decks_becomes_three() {
    let name = "converted/classic/b_elastic_damped/b_elastic_damped.y";
    let source = parse(&text(name));
    let (text, database, lost) = converted(&text(name), Dialect::Split);
    assert!(text.starts_with("/* classic Y2D deck, generated: b_elastic_damped */"), "{text}");
    assert!(text.contains("/* Converted by ypsilon from the classic dialect. */"));
    // Properties 1, -1, -1: one set of triangles, two of nodes.
    assert_eq!((database.integer("YDPE/NPROP"), database.integer("YDPN/NPNSET")), (1, 2));
    let mut classic = Database::new(Dialect::Classic);
    for item in 0..source.items().len() {
        let _ = classic.apply(&source, item);
    }
    let lambda = classic.reals("YDP/D1PELA").unwrap().get1(0);
    assert_eq!(reals(&database, "YDPE/D1PELA", 1), [2.0 * lambda]);
    let nodes = classic.integer("YDN/NNOPO") as usize;
    let sets: Vec<i64> =
        integers(&classic, "YDN/I1NOPR", nodes).into_iter().map(|property| property - 1).collect();
    assert_eq!(integers(&database, "YDN/I1NOPR", nodes), sets);
    let penalty = classic.reals("YDP/D1PEPC").unwrap().get1(0);
    assert_eq!(reals(&database, "YDPE/D1PEPT", 1), [0.1 * penalty]);
    assert_told(&lost, "restart decks");
    assert!(lost.len() == 1, "{lost:?}");
}

#[test]
fn the_ramp_becomes_a_table_and_comes_back() {
    let (split_text, split, _) = converted(&text(CLASSIC), Dialect::Split);
    let table = split.reals("YDPN/D3PNFAC").unwrap();
    let points = split.integer("YDPN/NPNFACT") as usize;
    let of_set: Vec<(f64, f64)> =
        (0..points).map(|i| (table.get3(0, 1, i), table.get3(1, 1, i))).collect();
    assert_eq!(of_set, [(0.0, 0.0), (0.01, 0.0), (0.03, 1.0)]);
    let (_, classic, lost) = converted(&split_text, Dialect::Classic);
    assert_eq!(classic.real("YDC/DCGRST"), 0.01);
    assert!((classic.real("YDC/DCRMPT") - 0.02).abs() < 1e-17);
    assert!(lost.is_empty(), "{lost:?}");
    let step = edited(&text(CLASSIC), &[("DCRMPT 2.00000000000000004e-02", "DCRMPT 0")]);
    let (_, split, _) = converted(&step, Dialect::Split);
    let table = split.reals("YDPN/D3PNFAC").unwrap();
    let last = [table.get3(0, 1, 1), table.get3(1, 1, 1)];
    assert!(last[0] < 0.01 && last[0] > 0.01 - 1e-15 && last[1] == 0.0, "{last:?}");
}

#[test]
fn joint_properties_are_renumbered() {
    let source = data("converted/ygeo/g_joint_pair/g_joint_pair.y");
    let (classic_text, classic, lost) =
        converted(&fs::read_to_string(source).unwrap(), Dialect::Classic);
    assert_eq!(integers(&classic, "YDP/I1PTYP", 5), [1, 3, -1, -1, -1]);
    assert_eq!(integers(&classic, "YDP/I1PEJP", 5)[0], 1);
    assert_eq!(integers(&classic, "YDP/I1PEMN", 5), [3, 0, 0, 0, 0]);
    assert_eq!(integers(&classic, "YDN/I1NOPR", 4), [2, 4, 3, 2]);
    assert_eq!(reals(&classic, "YDP/D1PEGT", 2), [0.0, 2.0]);
    assert_eq!(reals(&classic, "YDP/D1PEGS", 2), [0.0, 8.0]);
    assert_eq!(reals(&classic, "YDP/D1PICF", 2), [0.0, 0.6]);
    assert_told(&lost, "tension lowers the shear strength");
    let (_, back, lost) = converted(&classic_text, Dialect::YGeo);
    assert_eq!(integers(&back, "YDN/I1NOPR", 4), [0, 2, 1, 0]);
    assert_eq!(reals(&back, "YDPJ/D1PJGS", 1), [8.0]);
    let record = back.integers("YDPM/I2PMSET").unwrap();
    assert_eq!([0, 1, 2].map(|column| record.get2(column, 0)), [1, 3, 0]);
    let law = back.reals("YDPE/D2PEINT").unwrap();
    assert_eq!([0, 1, 2, 3, 4].map(|column| law.get2(column, 0)), [0.0, 0.0, 0.5, 1e11, 1e10]);
    assert_told(&lost, "another law");
}

#[test]
fn what_ygeo_needs_is_there() {
    let (_, database, lost) = converted(&text(SPLIT), Dialect::YGeo);
    assert!(lost.is_empty(), "{lost:?}");
    for keyword in yformat::keywords::tables(Dialect::YGeo)
        .iter()
        .filter(|table| !["YDR", "YDSB", "YDPS", "YDFN", "YDB", "YDS"].contains(&table.database))
        .flat_map(|table| table.keywords)
        .filter(|keyword| keyword.role == yformat::keywords::Role::Required)
    {
        let name = format!("{}/{}", keyword.database, keyword.name);
        assert!(database.given(&name).is_some(), "{name} is missing");
    }
    assert_eq!(reals(&database, "YDPJ/D1PJGS", 1), reals(&database, "YDPJ/D1PJGF", 1));
}

#[test]
fn losses_of_ygeo_decks_are_told() {
    let told = |edits: &[(&str, &str)]| converted(&edited(&text(YGEO), edits), Dialect::Split).2;
    assert_eq!(told(&[]).len(), 1);
    assert_told(&told(&[]), "fracture energy of opening in sliding");
    for (old, new, words) in [
        ("IUSEHY 0", "IUSEHY 1", "unload"),
        ("D1USAF 1\n0.0", "D1USAF 1\n1.0", "isotropic"),
        ("I1USAN 1\n0", "I1USAN 1\n2", "not anisotropic"),
        ("I1PEXC 1\n0", "I1PEXC 1\n1", "not excavated"),
        ("I1PNFX 3\n1", "I1PNFX 3\n4", "does not absorb"),
        ("I1OHYT 1 15", "I1OHYT 1 21", "type 21"),
        ("YDPE/I1PTYP 1\n1", "YDPE/I1PTYP 1\n6", "small strains only"),
        ("$YDOIT", "/YD/YDIS/IUSEIS 1 $YDOIT", "in-situ"),
        ("$YDOIT", "/YD/YDB/NBORH 1 $YDOIT", "boreholes"),
        ("$YDOIT", "/YD/YDI/D2SLDIS 21 1 1 0.5 $YDOIT", "sliding of an earlier run"),
        ("$YDOIT", "$YDOIT /YD/YDC/MCSTEP 4000 /YD/YDN/D1NMCT 0 $YDOIT", "D1NMCT of a later stage"),
    ] {
        assert_told(&told(&[(old, new)]), words);
    }
}

#[test]
fn frozen_nodes_do_not_absorb_waves_in_ygeo() {
    let frozen = edited(&text(SPLIT), &[("I1PNFX 4\n1", "I1PNFX 4\n4")]);
    assert_eq!(integers(&converted(&frozen, Dialect::YGeo).1, "YDPN/I1PNFX", 4), [0, 3, 3, 1]);
    let classic = converted(&frozen, Dialect::Classic).1;
    assert_eq!(integers(&classic, "YDP/I1PNFX", 6), [0, 0, 4, 3, 3, 1]);
}

#[test]
fn plane_strain_becomes_lame_constants() {
    let plane = edited(&text(YGEO), &[("YDPE/I1PTYP 1\n1", "YDPE/I1PTYP 1\n6")]);
    let (_, database, _) = converted(&plane, Dialect::Split);
    let lambda = 1e10 * 0.2 / (1.2 * 0.6);
    let found = reals(&database, "YDPE/D1PELA", 1)[0];
    assert!((found / lambda - 1.0).abs() < 1e-14, "{found}");
    assert_eq!(integers(&database, "YDPE/I1PTYP", 1), [1]);
}

#[test]
fn later_stages_keep_their_control_values() {
    let staged = edited(&text(YGEO), &[("$YDOIT", "$YDOIT /YD/YDC/MCSTEP 4000 $YDOIT")]);
    let (text, _, _) = converted(&staged, Dialect::Split);
    assert!(text.ends_with("$YDOIT\n/YD/YDC/MCSTEP 4000\n$YDOIT\n$YSTOP\n"), "{text}");
}

#[test]
fn pairs_that_no_single_values_make_are_told() {
    let name = "split2d/x_tower_slides/x_tower_slides.y";
    let (ygeo, database, lost) = converted(&text(name), Dialect::YGeo);
    assert!(lost.is_empty(), "{lost:?}");
    let laws = database.reals("YDPE/D2PEINT").unwrap();
    let sets = database.integer("YDPE/NPROP") as usize;
    assert_eq!(laws.given_shape(), [5, sets * (sets + 1) / 2]);
    let (_, _, lost) = converted(&ygeo, Dialect::Split);
    assert!(lost.is_empty(), "{lost:?}");
    // Sets 0 and 1 do not slide as easily as set 0 does on itself.
    let place = ygeo.find("D2PEINT").unwrap();
    let (before, after) = ygeo.split_at(place);
    let record = after.lines().nth(2).unwrap();
    let mut words: Vec<&str> = record.split(' ').collect();
    assert_eq!(words[..2], ["0.0", "1.0"]);
    words[2] = "7.5";
    let changed = format!("{before}{}", after.replacen(record, &words.join(" "), 1));
    let (_, _, lost) = converted(&changed, Dialect::Split);
    assert_told(&lost, "the friction of element sets 0 and 1 is not");
}

#[test]
fn what_cannot_be_converted_is_an_error() {
    let refused = |text: &str, to| convert_deck(&parse(text), to).unwrap_err();
    assert!(matches!(refused(&text(SPLIT), Dialect::Split), DialectError::Same(_)));
    assert!(matches!(refused(&text(SPLIT), Dialect::Y3d), DialectError::Unsupported(_)));
    assert!(matches!(
        refused(&edited(&text(SPLIT), &[("$YDOIT", "")]), Dialect::YGeo),
        DialectError::NothingRuns
    ));
    for (old, new, words) in [
        ("NNOPO 4", "NNOPO 5", "NNOPO is 5, but YDN/D2NCI gives 4"),
        ("NELEM 2", "NELEM -2", "NELEM is -2"),
        ("NNODIM 2", "NNODIM 3", "3 dimensions"),
        ("1 3 2\n", "1 4 2\n", "element 1 names node 4; nodes run from 0 to 3"),
        ("YDE/I1ELPR 2\n0 0", "YDE/I1ELPR 2\n0 1", "element 1 is a joint already"),
    ] {
        let edited = edited(&text(SPLIT), &[(old, new)]);
        let deck = Deck::parse("deck.y", edited).deck;
        let said = convert_deck(&deck, Dialect::YGeo).unwrap_err().to_string();
        assert!(said.contains(words), "{said}\ninstead of\n{words}");
    }
    let stiff = edited(
        &text(YGEO),
        &[
            ("YDPE/D1PELA 1\n2", "YDPE/D1PELA 1\n1e308 /* 2"),
            ("/YD/YDPE/D1PEMU", "*/ /YD/YDPE/D1PEMU"),
        ],
    );
    let said = refused(&stiff, Dialect::Split).to_string();
    assert_eq!(said, "the values for YDPE/D1PELA are not finite");
}

#[test]
fn decks_are_never_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("deck.y");
    fs::write(&output, "mine").unwrap();
    let error = deck_to_dialect(&data(SPLIT), &output, Dialect::YGeo).unwrap_err();
    assert!(matches!(error, ConvertError::DeckExists { .. }), "{error}");
    assert_eq!(fs::read_to_string(&output).unwrap(), "mine");
}

proptest! {
    /// Whatever word is replaced by whatever number: a deck, or an error, but no panic and no
    /// memory beyond what the deck holds.
    #[test]
    fn no_deck_makes_it_panic(
        source in 0..3_usize,
        to in 0..3_usize,
        changes in prop::collection::vec(
            (any::<prop::sample::Index>(), "-?[0-9]{1,18}|[0-9.e-]{1,8}|-1|0|1|2|3|4|21|231|1e308|inf"), 1..5),
    ) {
        let (text, name) = match source {
            0 => (text(CLASSIC), Dialect::Classic),
            1 => (text(YGEO), Dialect::YGeo),
            _ => (text(SPLIT), Dialect::Split),
        };
        let to = [Dialect::Split, Dialect::Classic, Dialect::YGeo][to];
        let mut words: Vec<&str> = text.split_inclusive(char::is_whitespace).collect();
        let replaced: Vec<String> = changes.iter().map(|(_, word)| format!("{word} ")).collect();
        for ((index, _), word) in changes.iter().zip(&replaced) {
            let at = index.index(words.len());
            words[at] = word;
        }
        let deck = DeckReader::new().dialect(Some(name)).parse("deck.y", words.concat()).deck;
        if let Ok(converted) = convert_deck(&deck, to) {
            let _ = converted.deck.to_text();
        }
    }
}
