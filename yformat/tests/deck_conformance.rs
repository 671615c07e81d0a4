//! What the original readers make of small decks, as observed by running them.

use yformat::database::Database;
use yformat::deck::{Deck, DeckReader, ItemKind, ParseOutcome};
use yformat::dialect::Dialect::{self, Classic, Split, YGeo};

fn read(dialect: Dialect, text: &str) -> ParseOutcome {
    DeckReader::new().dialect(dialect).parse("a.y", text)
}

fn runs(deck: &Deck) -> usize {
    deck.items().iter().filter(|item| item.kind() == &ItemKind::Run).count()
}

/// Executes a whole deck; nothing may be wrong with its order.
fn execute(deck: &Deck) -> Database {
    let mut database = Database::new(deck.dialect());
    for item in 0..deck.items().len() {
        let found = database.apply(deck, item);
        assert!(!found.iter().any(|found| found.is_error()), "{found:?}");
    }
    database
}

fn codes(outcome: &ParseOutcome) -> Vec<&'static str> {
    outcome.diagnostics.iter().map(|found| found.code).collect()
}

/// Text; runs; MCSTEP; NCSTEP; findings.
type Case = (&'static str, usize, i64, i64, &'static [&'static str]);

#[test]
fn words_comments_and_scalars() {
    let cases: &[Case] = &[
        ("/YD/YDC/MCSTEP 5 $YDOIT", 0, 5, 0, &["deck::dropped-word", "deck::no-run"]),
        ("/YD/YDC/MCSTEP 5 $YDOIT\n", 1, 5, 0, &[]),
        (
            "/*x*/ /YD/YDC/MCSTEP 5 */ /YD/YDC/NCSTEP 2 $YDOIT\n",
            1,
            0,
            2,
            &["deck::swallowed-keywords"],
        ),
        ("/**/ /YD/YDC/MCSTEP 5 $YDOIT\n", 0, 0, 0, &["deck::unclosed-comment", "deck::no-run"]),
        ("/*a */junk /YD/YDC/MCSTEP 5 $YDOIT\n", 1, 5, 0, &[]),
        ("/YD/YDC/MCSTEP /* c */ 5 $YDOIT\n", 0, 0, 0, &["deck::comment-inside-values"]),
        ("/YD/YDC/MCSTEP 5/* c */ $YDOIT\n", 1, 5, 0, &[]),
        ("/YD/YDC/MCSTEP $YDOIT\n", 1, 0, 0, &["deck::missing-value"]),
        ("/YD/YDC/MCSTEPXYZ 7 $YDOITNOW\n", 1, 7, 0, &["deck::trailing-characters"]),
        ("/YD/YDC/MCSTE 7\n", 0, 0, 0, &["deck::unknown-keyword"]),
        ("/YD/YDC/FOO 5\n", 0, 0, 0, &["deck::unknown-keyword"]),
        ("/YD/YDZ/FOO 5\n", 0, 0, 0, &["deck::unknown-database"]),
        ("/yd/ydc/mcstep 5\n", 0, 0, 0, &["deck::unknown-word"]),
        ("/YD/YDC/MCSTEP 5\r\n$YDOIT\r\n", 1, 5, 0, &[]),
        ("/YD/YDC/MCSTEP\x0b\x0c5 $YDOIT $YSTOP /YD/YDC/MCSTEP 9\n", 1, 5, 0, &[]),
        ("/YD/YDC/MCSTEP +7 /YD/YDC/NCSTEP 010 $YDOIT\n", 1, 7, 10, &[]),
        ("/YD/YDC/MCSTEP 2e4 $YDOIT\n", 0, 2, 0, &["deck::glued-text"]),
        ("/YD/YDC/MCSTEP 20000.0 $YDOIT\n", 0, 20000, 0, &["deck::glued-text"]),
        ("/YD/YDC/MCSTEP 0x10 $YDOIT\n", 0, 0, 0, &["deck::glued-text"]),
        ("/YD/YDC/MCSTEP 5 3 $YDOIT\n", 0, 5, 0, &["deck::surplus-values"]),
        ("/YD/YDC/MCSTEP five $YDOIT\n", 0, 0, 0, &["deck::not-a-number"]),
        ("/YD/YDC/MCSTEP 99999999999999999999 $YDOIT\n", 0, 0, 0, &["deck::number-out-of-range"]),
        ("/YD/YDC/DCTIME nan $YDOIT\n", 0, 0, 0, &["deck::not-a-number"]),
        ("/YD/YDC/DCTIME -Infinity $YDOIT\n", 0, 0, 0, &["deck::not-a-number"]),
        ("/YD/YDC/DCTIME 1e400 $YDOIT\n", 0, 0, 0, &["deck::number-out-of-range"]),
        ("/YD/YDC/DCTIME 0x1.8p3 $YDOIT\n", 0, 0, 0, &["deck::not-a-number"]),
        ("/YD/YDC/DCTIME 1e /YD/YDC/MCSTEP 5 $YDOIT\n", 1, 5, 0, &["deck::incomplete-exponent"]),
        ("/YD/YDC/MCSTEP + $YDOIT\n", 1, 0, 0, &["deck::lone-sign"]),
        ("\u{feff}/YD/YDC/MCSTEP 5 $YDOIT\n", 0, 0, 0, &["deck::byte-order-mark"]),
        ("/YD/YDC/DCSIZC -1 $YDOIT\n", 0, 0, 0, &["deck::negative-parameter"]),
        ("/* a */ */ $YDOIT\n", 0, 0, 0, &["deck::unknown-word"]),
    ];
    for (text, expected_runs, last, first, expected) in cases {
        let outcome = read(Split, text);
        let database = execute(&outcome.deck);
        assert_eq!(codes(&outcome), *expected, "{text}");
        assert_eq!(runs(&outcome.deck), *expected_runs, "{text}");
        assert_eq!(database.integer("YDC/MCSTEP"), *last, "{text}");
        assert_eq!(database.integer("YDC/NCSTEP"), *first, "{text}");
    }
}

#[test]
fn a_comment_holds_a_hundred_words() {
    for (words, fits) in [(99, true), (100, false)] {
        let text = format!("/* {}*/ /YD/YDC/MCSTEP 5 $YDOIT\n", "x ".repeat(words));
        let outcome = read(Split, &text);
        assert_eq!(!outcome.has_errors(), fits, "{words}");
        if !fits {
            assert_eq!(codes(&outcome), ["deck::comment-too-long"]);
        }
    }
}

/// Text before `$YDOIT`; first entries of D1PERO; findings.
type ArrayCase = (&'static str, &'static [f64], &'static [&'static str]);

#[test]
fn arrays_of_rank_1() {
    let cases: &[ArrayCase] = &[
        ("4 1 2 3 4", &[1., 2., 3., 4.], &[]),
        ("2 1 2", &[1., 2., 0., 0.], &[]),
        ("0", &[0., 0., 0., 0.], &[]),
        ("4 1 2 3", &[1., 2., 3., 3.], &["deck::missing-values"]),
        ("4 1 2 /* x */", &[1., 2., 2., 2.], &["deck::missing-values"]),
        ("4 1 2 /* x */ 3 4", &[1., 2., 2., 2.], &["deck::comment-inside-values"]),
        ("4 1 + 2 3", &[1., 1., 2., 3.], &["deck::lone-sign"]),
        ("4 1.0D3 2 3 4", &[1., 1., 1., 1.], &["deck::glued-text"]),
        ("2 1 2 3 4 5", &[1., 2., 0., 0.], &["deck::surplus-values"]),
        ("-3", &[0., 0., 0., 0.], &["deck::negative-count"]),
        ("99999999999", &[], &["deck::no-values"]),
        ("4 x", &[], &["deck::no-values"]),
        ("", &[], &["deck::unreadable-count"]),
    ];
    for (values, expected, findings) in cases {
        for (dialect, database) in [(Classic, "YDP"), (Split, "YDPE")] {
            let text = format!("/YD/{database}/MPROP 4 /YD/{database}/D1PERO {values} $YDOIT\n");
            let outcome = read(dialect, &text);
            assert_eq!(codes(&outcome), *findings, "{text}");
            let values = execute(&outcome.deck);
            let densities = values.reals(&format!("{database}/D1PERO"));
            assert_eq!(densities.is_some(), !expected.is_empty(), "{text}");
            for (i, value) in expected.iter().enumerate() {
                assert_eq!(densities.unwrap().get1(i), *value, "{text}, entry {i}");
            }
        }
    }
}

#[test]
fn counts_glued_to_the_keyword_are_lost() {
    let outcome = read(Classic, "/YD/YDO/MOHYS 2 /YD/YDO/D1OHYX1 \n 0 $YDOITNOW\n");
    assert_eq!(codes(&outcome), ["deck::trailing-characters"]);
    assert_eq!(execute(&outcome.deck).reals("YDO/D1OHYX").unwrap().get1(1), 0.0);
    assert_eq!(runs(&outcome.deck), 1);
    assert_eq!(outcome.deck.echo_lines(), ["/YD/YDO/MOHYS", "/YD/YDO/D1OHYX1", "$YDOITNOW"]);
}

#[test]
fn the_classic_program_stores_the_third_load_code_into_the_mesh_codes() {
    let outcome =
        read(Classic, "/YD/YDP/MPROP 4 /YD/YDP/I1PEMN 4 3 3 3 3 /YD/YDP/I1PNFZ 2 8 8 $YDOIT\n");
    let database = execute(&outcome.deck);
    let codes = database.integers("YDP/I1PEMN").unwrap();
    assert_eq!([0, 1, 2, 3].map(|i| codes.get1(i)), [8, 8, -1, -1]);
}

#[test]
fn arrays_of_rank_2() {
    let rows = |text: &str| {
        let outcome =
            read(Split, &format!("/YD/YDE/MELEM 3 /YD/YDE/MELNO 2 /YD/YDE/I2ELTO {text} $YDOIT\n"));
        assert!(!outcome.has_errors(), "{text}");
        let database = execute(&outcome.deck);
        let nodes = database.integers("YDE/I2ELTO").unwrap();
        [0, 1].map(|i| [0, 1, 2].map(|j| nodes.get2(i, j)))
    };
    assert_eq!(rows("21 2 3 1 2 3 4 5 6"), [[1, 3, 5], [2, 4, 6]]);
    assert_eq!(rows("99 2 3 1 2 3 4 5 6"), [[1, 3, 5], [2, 4, 6]]);
    assert_eq!(rows("12 2 2 1 2 3 4"), [[1, 2, -1], [3, 4, -1]]);
    assert_eq!(rows("21 0 0"), [[-1; 3]; 2]);
}

#[test]
fn arrays_of_rank_3() {
    let rows = |order: i64| {
        let text = format!(
            "/YD/YDPN/MPNSET 2 /YD/YDPN/MPNFACT 3 /YD/YDPN/D3PNFAC {order} 2 2 3 1 2 3 4 5 6 7 8 9 10 11 12 $YDOIT\n"
        );
        let outcome = read(YGeo, &text);
        let database = execute(&outcome.deck);
        let table = database.reals("YDPN/D3PNFAC").unwrap();
        [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| [0, 1, 2].map(|k| table.get3(i, j, k) as i64))
    };
    assert_eq!(rows(123), [[1, 2, 3], [4, 5, 6], [7, 8, 9], [10, 11, 12]]);
    assert_eq!(rows(132), [[1, 3, 5], [2, 4, 6], [7, 9, 11], [8, 10, 12]]);
    assert_eq!(rows(213), [[1, 2, 3], [7, 8, 9], [4, 5, 6], [10, 11, 12]]);
    assert_eq!(rows(231), [[1, 3, 5], [7, 9, 11], [2, 4, 6], [8, 10, 12]]);
    assert_eq!(rows(312), [[1, 5, 9], [2, 6, 10], [3, 7, 11], [4, 8, 12]]);
    assert_eq!(rows(321), [[1, 5, 9], [3, 7, 11], [2, 6, 10], [4, 8, 12]]);
    assert_eq!(rows(111), [[-1; 3]; 4]);
}

#[test]
fn y_geo_reads_scratch_arrays_behind_two_keywords() {
    for values in ["2 5 6\n/YD/YDC/MCSTEP 1", "2 5 6 1 9\n"] {
        let outcome = read(YGeo, &format!("/YD/YDE/MELEM 3 /YD/YDE/I1ELPR {values} $YDOIT\n"));
        assert!(!outcome.has_errors(), "{values}");
        let database = execute(&outcome.deck);
        let sets = database.integers("YDE/I1ELPR").unwrap();
        assert_eq!([0, 1, 2].map(|i| sets.get1(i)), [5, 6, -1]);
    }
}

#[test]
fn later_stages_change_what_they_name() {
    let text = "/YD/YDP/MPROP 3 /YD/YDP/D1PERO 3 1 2 3 $YDOIT /YD/YDP/D1PERO 1 7 $YDOIT\n";
    let deck = read(Classic, text).deck;
    let mut database = Database::new(Classic);
    let mut seen = Vec::new();
    for stage in deck.stages().into_iter().filter(|stage| stage.runs) {
        stage.items.for_each(|item| assert!(database.apply(&deck, item).is_empty()));
        let densities = database.reals("YDP/D1PERO").unwrap();
        seen.push([0, 1, 2].map(|i| densities.get1(i)));
    }
    assert_eq!(seen, [[1.0, 2.0, 3.0], [7.0, 0.0, 0.0]]);
}

#[test]
fn included_files_may_end_in_a_number_but_not_in_a_word() {
    let mut reader = DeckReader::new().dialect(Split).includes(|name: &str| {
        Ok(if name == "a" { b"/YD/YDC/MCSTEP 3".to_vec() } else { b"$YSTOP".to_vec() })
    });
    let outcome = reader.parse("deck.y", "$YINCL a $YINCL b $YDOIT\n");
    assert_eq!(execute(&outcome.deck).integer("YDC/MCSTEP"), 3);
    assert_eq!(runs(&outcome.deck), 1);
    let echo = outcome.deck.echo_lines();
    assert_eq!(
        echo[..4],
        ["$YINCL", "* open included-file: a", "/YD/YDC/MCSTEP", "* close included-file."]
    );
    assert_eq!(echo.last().map(String::as_str), Some("$YDOIT"));
}

#[test]
fn files_that_include_themselves_stop_at_the_ninth_level() {
    let mut opened = 0;
    let mut reader = DeckReader::new().dialect(Split).includes(|_: &str| {
        opened += 1;
        Ok(b"$YINCL a\n".to_vec())
    });
    let outcome = reader.parse("deck.y", "$YINCL a\n");
    assert_eq!(codes(&outcome), ["deck::include-too-deep"]);
    drop(reader);
    assert_eq!(opened, 9);
}

#[test]
fn restart_decks_of_the_classic_program_are_read_past_their_mistake() {
    let text = "/YD/YDN/MNOPO 2 /YD/YDN/D1NMCT 0 \n +1.0e+00 nan \n/YD/YDC/MCSTEP 4 $YDOIT\n";
    let outcome = read(Classic, text);
    assert_eq!(codes(&outcome), ["deck::restart-masses"]);
    assert_eq!(execute(&outcome.deck).integer("YDC/MCSTEP"), 4);
    assert_eq!(codes(&read(Split, text)), ["deck::surplus-values"]);
}

#[test]
fn undefined_joint_states_of_restart_decks_are_taken() {
    let text = "/YD/YDJ/NJOINT 3 /YD/YDJ/D1JAPH 3  -nan +1.5e+00 +inf /YD/YDC/MCSTEP 4 $YDOIT\n";
    let outcome = read(Classic, text);
    assert_eq!(codes(&outcome), ["deck::undefined-state"]);
    assert_eq!(outcome.deck.to_text(), text);
    assert_eq!(outcome.diagnostics[0].severity, yformat::diagnostic::Severity::Note);
    let database = execute(&outcome.deck);
    let apertures = database.reals("YDJ/D1JAPH").unwrap();
    assert!(apertures.get1(0).is_nan() && apertures.get1(0).is_sign_negative());
    assert_eq!([apertures.get1(1), apertures.get1(2)], [1.5, f64::INFINITY]);
    let span = apertures.span(&outcome.deck, [1, 0, 0]).unwrap();
    assert_eq!(outcome.deck.sources().text(span), "+1.5e+00");
    // elsewhere, and for what is no such word, it stays an error
    for refused in
        ["/YD/YDN/MNOPO 1 /YD/YDN/D1NMCT 1 nan\n", "/YD/YDJ/NJOINT 1 /YD/YDJ/D1JAPH 1 nano\n"]
    {
        assert_eq!(codes(&read(Classic, refused)), ["deck::not-a-number"], "{refused}");
    }
}

#[test]
fn dialects_keep_their_keywords_apart() {
    let unknown = |dialect, text: &str| {
        let outcome = read(dialect, &format!("{text} 6 $YDOIT\n"));
        outcome.error().map(|error| (error.code, error.notes.help.clone().unwrap_or_default()))
    };
    let (code, help) = unknown(Classic, "/YD/YDI/MISTATE").unwrap();
    assert_eq!(code, "deck::unknown-keyword");
    assert_eq!(help, "it belongs to the split and y-geo dialects; this deck is read as classic");
    assert_eq!(unknown(YGeo, "/YD/YDPE/D1PEPT").unwrap().0, "deck::unknown-keyword");
    assert!(unknown(Classic, "/YD/YDP/D1PEGF").unwrap().1.contains("book"));
    // Y-Geo takes every name that begins with D1PEG for the shear modulus.
    let outcome = read(YGeo, "/YD/YDPE/MPROP 1 /YD/YDPE/D1PEGT 1 6 $YDOIT\n");
    assert_eq!(codes(&outcome), ["deck::trailing-characters"]);
    assert_eq!(execute(&outcome.deck).reals("YDPE/D1PEG").unwrap().get1(0), 6.0);
    assert_eq!(
        codes(&read(Split, "/YD/YDN/MNODIM 2 /YD/YDN/MNODIX 2 $YDOIT\n")),
        ["deck::trailing-characters"]
    );
}

#[test]
fn sizes_come_first_and_suffice() {
    let errors = |text: &str| {
        let deck = read(Split, &format!("{text} $YDOIT\n")).deck;
        let mut database = Database::new(Split);
        let found: Vec<_> =
            (0..deck.items().len()).flat_map(|item| database.apply(&deck, item)).collect();
        found
            .into_iter()
            .map(|found| (found.code, found.notes.help.unwrap_or_default()))
            .collect::<Vec<_>>()
    };
    let found = errors("/YD/YDPE/D1PERO 1 5 /YD/YDPE/MPROP 1");
    assert_eq!(found[0].0, "deck::size-missing");
    assert_eq!(found[0].1, "move /YD/YDPE/MPROP from line 1 before /YD/YDPE/D1PERO");
    assert_eq!(errors("/YD/YDPE/MPROP 1 /YD/YDPE/D1PERO 2 5 6")[0].0, "deck::too-long");
    assert_eq!(errors("/YD/YDPN/D1PNAX 0 /YD/YDPN/MPNSET 1"), []);
    let found = errors("/YD/YDPN/MPNSET 1 /YD/YDPN/D1PNAX 1 5 /YD/YDPN/MPNSET 2");
    assert_eq!(found[0].0, "deck::values-lost");
    let found = errors("/YD/YDPE/MPROP 1 /YD/YDPE/D1PERO 1 5 /YD/YDPE/MPROP 2 /YD/YDPE/D1PERO 1 5");
    assert_eq!(
        found.iter().map(|found| found.0).collect::<Vec<_>>(),
        ["deck::array-stays-small", "deck::array-outgrown"]
    );
}

#[test]
fn the_split_program_makes_arrays_that_the_deck_leaves_out() {
    let text = "/YD/YDPN/MPNSET 2 /YD/YDPN/D1PNAY 1 5 /YD/YDN/MNODIM 2 /YD/YDN/MNOPO 3 /YD/YDC/ICOUTF -1 $YDOIT\n";
    let database = execute(&read(Split, text).deck);
    let real = |name: &str| database.reals(name).map(|field| field.get1(1));
    assert_eq!(real("YDPN/D1PNAX"), Some(1.0)); // not given: amplitude 1
    assert_eq!(real("YDPN/D1PNAY"), Some(0.0)); // given: entries left out are 0
    assert_eq!(real("YDPN/D1PNXX"), Some(1.0));
    assert_eq!(real("YDPN/D1PNXY"), Some(0.0));
    assert_eq!(database.integers("YDN/I1NOBF").map(|field| field.get1(0)), Some(0));
    assert_eq!(database.integers("YDN/I1NOPR"), None);
    assert_eq!(database.reals("YDN/D2NCI"), None);
    assert_eq!(database.integer("YDC/ICOUTF"), 10);
    assert_eq!(database.given("YDPN/D1PNAX"), None);
    assert_eq!(database.given("YDPN/D1PNAY"), Some(1));
}
