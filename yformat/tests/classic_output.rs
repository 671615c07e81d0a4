//! Restart decks, GiD meshes and logs of contact forces: what the original wrote comes back byte
//! for byte.

mod shared_files;

use proptest::prelude::*;
use yformat::classic_output::{
    ContactForceSums, MassCount, OutputNames, RestartDeck, RestartError,
};
use yformat::deck::DeckReader;
use yformat::dialect::Dialect;

const PAIR: &str = include_str!("data/classic/g_joint_pair4_restart.y");
const PAIR_MESH: &str = include_str!("data/classic/g_joint_pair.msh");
const FREE_FALL: &str = include_str!("data/classic/a_freefall9_restart.y");
const FREE_FALL_MESH: &str = include_str!("data/classic/a_freefall.msh");
const CONTACT_FORCES: &str = include_str!("data/classic/c_contact_normal_contactforce.txt");

fn parse(text: &str) -> RestartDeck {
    let (restart, found) = RestartDeck::parse("a_restart.y", text).unwrap();
    let codes: Vec<_> = found.iter().map(|found| found.code).collect();
    assert_eq!(codes.iter().filter(|code| **code == "deck::restart-masses").count(), 1);
    restart
}

fn deck_text(restart: &RestartDeck, masses: MassCount) -> String {
    let mut text = Vec::new();
    restart.write_to(&mut text, masses).unwrap();
    String::from_utf8(text).unwrap()
}

fn mesh_text(restart: &RestartDeck) -> String {
    let mut text = Vec::new();
    restart.mesh().write_to(&mut text).unwrap();
    String::from_utf8(text).unwrap()
}

#[test]
fn decks_and_meshes_of_the_original_come_back_byte_for_byte() {
    for (deck, mesh) in [(PAIR, PAIR_MESH), (FREE_FALL, FREE_FALL_MESH)] {
        let restart = parse(deck);
        assert_eq!(deck_text(&restart, MassCount::AsOriginal), deck);
        assert_eq!(mesh_text(&restart), mesh);
    }
    let mut meshes = 0;
    let decks = shared_files::with_ending("_restart.y");
    for path in &decks {
        let deck = std::fs::read_to_string(path).unwrap();
        let restart = parse(&deck);
        let ours = deck_text(&restart, MassCount::AsOriginal);
        assert!(ours == deck, "{}: {}", path.display(), first_difference(&ours, &deck));
        // One mesh per run is kept, that of the last restart deck.
        let folder = path.parent().unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let last = restart.control.end_step == restart.control.next_step;
        let base = name.trim_end_matches("_restart.y").trim_end_matches(|c: char| c.is_numeric());
        if last && let Ok(mesh) = std::fs::read_to_string(folder.join(format!("{base}.msh"))) {
            assert!(mesh_text(&restart) == mesh, "{}", path.display());
            meshes += 1;
        }
    }
    println!("{} shared restart decks and {meshes} meshes are unchanged", decks.len());
}

fn first_difference(ours: &str, theirs: &str) -> String {
    let pair = ours.lines().zip(theirs.lines()).find(|(ours, theirs)| ours != theirs);
    format!("{pair:?}")
}

#[test]
fn values_arrive_where_they_belong() {
    let restart = parse(PAIR);
    assert_eq!((restart.control.end_step, restart.control.next_step), (3000, 3000));
    assert_eq!((restart.control.next_snapshot, restart.control.digits), (5, 4));
    assert_eq!(restart.control.scales.aperture, 1e-7);
    assert_eq!(restart.elements.kinds.len(), 7);
    assert_eq!(restart.elements.nodes.row(0).unwrap(), [4, 5, 6, -1]);
    assert_eq!(restart.joints.len(), 5);
    assert_eq!(restart.joints[2].element, 4);
    assert_eq!(restart.joints[2].roughness, 15.0);
    assert_eq!(restart.nodes.masses[3..5], [0.0, 4.166666666666667]);
    assert_eq!(restart.nodes.velocities.len(), 10);
    assert_eq!(restart.properties.len(), 5);
    assert_eq!(restart.properties[1].kind, 3);
    assert_eq!(restart.histories[0].quantity, 15);
}

/// With the right count every dialect-conforming reader takes the deck, and all values are the
/// same.
#[test]
fn the_count_of_masses_can_be_written_correctly() {
    let restart = parse(PAIR);
    let mended = deck_text(&restart, MassCount::Correct);
    assert_eq!(mended, PAIR.replace("D1NMCT     0\n", "D1NMCT    10\n"));
    let outcome = DeckReader::new().dialect(Dialect::Classic).parse("a.y", mended.clone());
    assert_eq!(outcome.diagnostics, []);
    let (again, found) = RestartDeck::parse("a.y", mended).unwrap();
    assert_eq!((again, found.len()), (restart, 0));
}

#[test]
fn undefined_states_are_printed_as_the_c_library_prints_them() {
    let mut restart = parse(PAIR);
    restart.joints[0].hydraulic_aperture = f64::NAN;
    restart.joints[1].hydraulic_aperture = -f64::NAN;
    restart.joints[2].hydraulic_aperture = f64::NEG_INFINITY;
    let text = deck_text(&restart, MassCount::AsOriginal);
    let line = text.lines().skip_while(|line| !line.contains("D1JAPH")).nth(1).unwrap();
    let blanks = " ".repeat(24);
    assert!(line.starts_with(&format!("{blanks}+nan {blanks}-nan {blanks}-inf ")), "{line}");
    let again = parse(&text);
    assert!(again.joints[0].hydraulic_aperture.is_nan());
    assert_eq!(deck_text(&again, MassCount::AsOriginal), text);
}

#[test]
fn an_ordinary_deck_has_the_values_of_the_program() {
    let text = include_bytes!("data/classic/g_joint_pair.y").to_vec();
    let (start, _) = RestartDeck::parse("g_joint_pair.y", text).unwrap();
    assert_eq!((start.joints.len(), start.elements.kinds.clone()), (0, vec![-1, -1]));
    assert_eq!(start.nodes.masses, [0.0; 4]);
    assert_eq!(start.control.next_step, 0);
}

#[test]
fn mistakes_are_told() {
    let message = |text: &str| RestartDeck::parse("a.y", text).unwrap_err().to_string();
    let few = PAIR.replace("NELEM     7", "NELEM     9");
    assert_eq!(message(&few), "YDE/NELEM is 9, but YDE/I2ELTO gives 7: correct one of them");
    let wide = PAIR.replace("MELNO     4", "MELNO    40");
    assert_eq!(message(&wide), "YDE/MELNO is 40, expected 0 to 16 nodes");
    let broken = message("/YD/YDC/MCSTEP x\n");
    assert!(broken.starts_with("a.y:1:16: error[deck::"), "{broken}");
    let mut restart = parse(PAIR);
    restart.nodes.masses.pop();
    let refused = restart.write_to(Vec::new(), MassCount::Correct).unwrap_err();
    assert!(matches!(refused, RestartError::Length { array: "D1NMCT", expected: 10, found: 9 }));
}

#[test]
fn lines_of_contact_forces_come_back() {
    let mut logs = vec![CONTACT_FORCES.to_owned()];
    let paths = shared_files::with_ending(OutputNames::CONTACT_FORCES);
    logs.extend(paths.iter().map(|path| std::fs::read_to_string(path).unwrap()));
    let mut lines = 0;
    for line in logs.iter().flat_map(|log| log.lines()) {
        let numbers: Vec<f64> = line.split(' ').map(|word| word.parse().unwrap()).collect();
        let [a, b, c, d] = numbers[..] else { panic!("{line}") };
        let sums = ContactForceSums { magnitudes: [a, b], of_property_5: [c, d] };
        assert_eq!(sums.to_string(), line);
        lines += 1;
    }
    assert!(lines >= 10, "{lines}");
}

proptest! {
    /// Damaged decks end in an error or in values, never in a panic.
    #[test]
    fn damaged_decks_do_not_panic(
        damage in prop::collection::vec((0..14_000_usize, prop::sample::select(b" 0123456789-+.enai/$*\n".to_vec())), 0..8),
        length in 0..14_000_usize,
    ) {
        let mut bytes = PAIR.as_bytes().to_vec();
        for (index, byte) in damage {
            if let Some(slot) = bytes.get_mut(index) {
                *slot = byte;
            }
        }
        bytes.truncate(length.max(10_000));
        if let Ok((restart, _)) = RestartDeck::parse("a.y", bytes) {
            let _ = restart.write_to(std::io::sink(), MassCount::Correct);
            let _ = restart.mesh().write_to(std::io::sink());
        }
    }

    /// Sizes of any value are refused or harmless.
    #[test]
    fn damaged_sizes_do_not_panic(
        keyword in prop::sample::select(vec!["NELEM", "MELEM", "MELNO", "NELNO", "NJOINT", "NNOPO", "MNOPO", "MNODIM", "NPROP", "MPROP", "NOHYS", "MOHYS"]),
        value in prop_oneof![any::<i64>(), -2..30_i64],
    ) {
        let at = PAIR.find(&format!("/{keyword} ")).unwrap() + keyword.len() + 1;
        let end = at + PAIR[at..].find('\n').unwrap();
        let text = format!("{} {value}{}", &PAIR[..at], &PAIR[end..]);
        if let Ok((restart, _)) = RestartDeck::parse("a.y", text) {
            let _ = restart.write_to(std::io::sink(), MassCount::Correct);
        }
    }
}
