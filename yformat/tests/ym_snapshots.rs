//! `.ym` snapshots: those of the original come back as they were, reals to the quantum.

mod shared_files;

use proptest::prelude::*;
use yformat::database::Database;
use yformat::deck::DeckReader;
use yformat::dialect::Dialect;
use yformat::ym::{
    AcousticSource, BoundaryJoint, CodedRecord, Digits, FractureJoint, LineEnd, MeanVelocity,
    Record, RecordKind, Scales, Snapshot, SnapshotWriter, Triangle,
};

const PAIR: &[u8] = include_bytes!("data/classic/g_joint_pair4.ym");
const SHEAR: &[u8] = include_bytes!("data/classic/f_joint_shear4.ym");

/// The scales of the decks that wrote these.
const SCALES: Scales = Scales {
    coordinate: 1.0,
    force: 1e6,
    stress: 1e8,
    velocity: 100.0,
    displacement: 0.1,
    aperture: 1e-7,
};

fn count(snapshot: &Snapshot, kind: RecordKind) -> usize {
    snapshot.records.iter().filter(|record| record.kind() == kind).count()
}

#[test]
fn snapshots_of_the_original_are_rewritten_byte_for_byte() {
    let committed = [("pair", PAIR), ("shear", SHEAR)];
    for (name, text) in committed {
        assert_eq!(Snapshot::parse(name, text).unwrap().to_bytes(), text, "{name}");
    }
    let mut records = 0;
    for path in shared_files::with_ending(".ym") {
        let text = std::fs::read(&path).unwrap();
        let snapshot = Snapshot::read(&path).unwrap();
        assert!(snapshot.to_bytes() == text, "{}", path.display());
        records += snapshot.records.len();
    }
    println!("{records} records of shared snapshots are unchanged");
}

#[test]
fn the_kinds_are_told_apart() {
    let snapshot = Snapshot::parse("shear", SHEAR).unwrap();
    let kinds = [RecordKind::Triangle, RecordKind::FractureJoint, RecordKind::BoundaryJoint];
    assert_eq!(kinds.map(|kind| count(&snapshot, kind)), [8, 8, 8]);
    assert_eq!(count(&snapshot, RecordKind::AcousticSource), 8);
    assert_eq!(snapshot.records.len(), 32);
    assert_eq!((snapshot.line_end, snapshot.truncated), (LineEnd::LineFeed, None));
}

/// A dump of the original's memory after a step: exact reals.
struct Dump {
    coordinates: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    /// Property set and nodes.
    triangles: Vec<(i64, [usize; 3])>,
    /// Kind and nodes.
    joints: Vec<(i64, [usize; 4])>,
}

impl Dump {
    fn parse(text: &str) -> Self {
        let mut dump =
            Self { coordinates: vec![], velocities: vec![], triangles: vec![], joints: vec![] };
        for line in text.lines() {
            let words: Vec<&str> = line.split_whitespace().collect();
            let real = |k: usize| words[k].parse::<f64>().unwrap();
            let node = |k: usize| words[k].parse::<usize>().unwrap();
            match words[0] {
                "N" => {
                    dump.coordinates.push([real(2), real(3)]);
                    dump.velocities.push([real(4), real(5)]);
                }
                "T" => dump.triangles.push((real(2) as i64, [node(3), node(4), node(5)])),
                "J" => dump.joints.push((real(3) as i64, [node(4), node(5), node(6), node(7)])),
                _ => {}
            }
        }
        dump
    }

    /// What the original writes of this state, in its order; stresses and forces left at 0.
    fn records(&self, property_types: &[i64]) -> Vec<Record> {
        let mut records = Vec::new();
        for (property, &kind) in property_types.iter().enumerate() {
            if kind != 3 {
                let triangles = self.triangles.iter().filter(|(p, _)| *p == property as i64);
                records.extend(triangles.map(|(_, nodes)| {
                    Record::Triangle(Triangle {
                        corners: nodes.map(|node| self.coordinates[node]),
                        velocity: MeanVelocity::of_corners(nodes.map(|n| self.velocities[n])),
                        stress: [0.0; 3],
                        damage: 0.0,
                        contact_force: Some([0.0; 2]),
                    })
                }));
                continue;
            }
            records.extend(self.joints.iter().filter_map(|&(kind, nodes)| {
                let nodes = nodes.map(|node| self.coordinates[node]);
                match kind {
                    1 => Some(Record::BoundaryJoint(BoundaryJoint {
                        nodes,
                        contact_force: [0.0; 2],
                    })),
                    2.. => panic!("these states have no fractures"),
                    _ => None,
                }
            }));
        }
        records
    }
}

/// Codes coordinates and velocities of a dump and compares with the snapshot of the same step;
/// tells how many numbers were compared.
fn compare_with_dump(name: &str, deck: Vec<u8>, snapshot: &[u8], dump: &str) -> usize {
    let deck = DeckReader::new().dialect(Dialect::Classic).parse(name, deck).deck;
    let mut database = Database::new(Dialect::Classic);
    (0..deck.items().len()).for_each(|item| drop(database.apply(&deck, item)));
    let scales = Scales::from_database(&database).unwrap();
    let digits = Digits::new(database.integer("YDC/ICOUTP")).unwrap();
    let sets = database.integer("YDP/NPROP") as usize;
    let types = database.integers("YDP/I1PTYP").unwrap();
    let types: Vec<i64> = (0..sets).map(|set| types.get1(set)).collect();
    let records = Dump::parse(dump).records(&types);
    let snapshot = Snapshot::parse(name, snapshot).unwrap();
    assert_eq!(records.len(), snapshot.records.len(), "{name}");
    for (index, (record, theirs)) in records.iter().zip(&snapshot.records).enumerate() {
        let ours = CodedRecord::encode(record, digits, &scales);
        assert_eq!(ours.kind(), theirs.kind(), "{name} record {index}");
        assert_eq!(ours.numbers()[..8], theirs.numbers()[..8], "{name} record {index}");
    }
    8 * records.len()
}

/// Snapshot 0 shows the state after one step, which is dumped too.
#[test]
fn exact_values_are_coded_as_the_original_coded_them() {
    compare_with_dump(
        "pair",
        include_bytes!("data/classic/g_joint_pair.y").to_vec(),
        include_bytes!("data/classic/g_joint_pair0.ym"),
        include_str!("data/classic/g_joint_pair_state_1.txt"),
    );
    let mut numbers = 0;
    for path in shared_files::with_ending("state_1.txt") {
        let folder = path.parent().unwrap();
        let case = folder.file_name().unwrap().to_str().unwrap();
        let read = |name: String| std::fs::read(folder.join(name)).unwrap();
        let dump = std::fs::read_to_string(&path).unwrap();
        if dump.lines().any(|line| line.starts_with("J") && !" 0 1".contains(&joint_kind(line))) {
            println!("{case} begins with fractures, whose values the dump does not hold");
            continue;
        }
        let (deck, snapshot) = (read(format!("{case}.y")), read(format!("{case}0.ym")));
        numbers += compare_with_dump(case, deck, &snapshot, &dump);
    }
    println!("{numbers} numbers of shared snapshots are coded as the original did");
}

fn joint_kind(line: &str) -> String {
    format!(" {}", line.split_whitespace().nth(3).unwrap())
}

/// The restart deck of the same run, 600 steps later, has these failure modes (`D1JFMD` of the
/// joints that are fractures): a joint keeps its mode once it is broken.
#[test]
fn failure_modes_are_those_of_the_restart_deck() {
    let exact = [1.110117690420576, 2.0, 1.6227283851886123, 1.0, 2.0, 1.0, 1.0, 1.0];
    let snapshot = Snapshot::parse("shear", SHEAR).unwrap();
    let fractures = snapshot.records.iter().filter(|r| r.kind() == RecordKind::FractureJoint);
    let mut compared = 0;
    for (theirs, failure_mode) in fractures.zip(exact) {
        let Record::FractureJoint(decoded) = theirs.decode(&SCALES) else { panic!() };
        let record = Record::FractureJoint(FractureJoint { failure_mode, ..decoded });
        let ours = CodedRecord::encode(&record, theirs.digits(), &SCALES);
        assert_eq!(ours.numbers()[8], theirs.numbers()[8]);
        let error = failure_mode - decoded.failure_mode;
        assert!((0.0..=2.0 * theirs.digits().quantum()).contains(&error), "{error}");
        compared += 1;
    }
    assert_eq!(compared, 8);
}

#[test]
fn both_line_ends_are_kept() {
    let text = String::from_utf8(PAIR.to_vec()).unwrap().replace('\n', "\r\n");
    let snapshot = Snapshot::parse("pair", text.as_bytes()).unwrap();
    assert_eq!(snapshot.line_end, LineEnd::CarriageReturnLineFeed);
    assert_eq!(snapshot.to_bytes(), text.as_bytes());
    assert_eq!(snapshot.records, Snapshot::parse("pair", PAIR).unwrap().records);
}

#[test]
fn a_cut_last_line_is_left_out_and_told() {
    let cut = Snapshot::parse("pair", &PAIR[..PAIR.len() - 5]).unwrap();
    let whole = Snapshot::parse("pair", PAIR).unwrap();
    assert_eq!(cut.truncated, Some(whole.records.len() + 1));
    assert_eq!(cut.records, whole.records[..whole.records.len() - 1]);
    let unended = Snapshot::parse("pair", &PAIR[..PAIR.len() - 1]).unwrap();
    assert_eq!(unended, whole);
}

#[test]
fn mistakes_are_named_with_file_and_line() {
    for (text, message) in [
        ("", "a.ym:1: a .ym snapshot begins with the line `CODED`, this file with ``"),
        ("CODE\n", "a.ym:1: a .ym snapshot begins with the line `CODED`, this file with `CODE`"),
        (
            "CODED\n\n0-600\n",
            "a.ym:3: the line `0-600` begins with no number of digits: 1 to 9 expected (ICOUTP of the deck)",
        ),
        (
            "CODED\n1-60000000\n1-6000 000\n",
            "a.ym:3: column 7: ` ` is none of the 90 digits of .ym files",
        ),
        (
            "CODED\n1-600000\n1-60000000\n",
            "a.ym:2: the line has 8 characters, 10 are announced by its first two",
        ),
        (
            "CODED\n1-20000000\n",
            "a.ym:2: record type 2 is unknown: expected 1 (triangle), 3 (fracture), 5 (boundary) or 6 (acoustic source)",
        ),
        ("CODED\n1-10000000\n", "a.ym:2: a record of type 1 has count 10, expected 17 or 15"),
        ("CODED\n1-50000000\n", "a.ym:2: a record of type 5 has count 10, expected 19"),
        ("CODED\n1\n", "a.ym:2: the line has 1 characters, 2 are announced by its first two"),
    ] {
        let found = Snapshot::parse("a.ym", text.as_bytes()).unwrap_err().to_string();
        assert_eq!(found, message);
    }
}

/// Sums of three velocities are divided once, as the original does.
#[test]
fn mean_velocities_are_divided_once() {
    let corners = [[0.1, 1.0], [0.2, 2.0], [0.3, 6.0]];
    let velocity = MeanVelocity::of_corners(corners);
    assert_eq!(velocity.get(), [(0.1 + 0.2 + 0.3) / 3.0, 3.0]);
    assert_eq!(MeanVelocity::new([0.1, 0.7]).get(), [0.1, 0.7]);
}

#[test]
fn closed_apertures_and_absent_events_are_at_the_ends_of_the_range() {
    let digits = Digits::new(4).unwrap();
    let joint = FractureJoint {
        nodes: [[0.0; 2]; 4],
        failure_mode: 2.57,
        normal_stress: f64::NAN,
        shear_stress: 0.0,
        sliding_force: 0.0,
        aperture: 0.0,
        shear_displacement: 0.0,
        dilation: 0.0,
        hydraulic_aperture: 1.0,
    };
    let coded = CodedRecord::encode(&Record::FractureJoint(joint), digits, &SCALES);
    assert_eq!(coded.numbers()[8], digits.largest());
    assert_eq!(coded.numbers()[9], 0);
    assert_eq!(coded.numbers()[12], digits.largest());
    let source = AcousticSource { position: [0.0; 2], magnitude: -1e15 };
    let coded = CodedRecord::encode(&Record::AcousticSource(source), digits, &SCALES);
    let Record::AcousticSource(back) = coded.decode(&SCALES) else { panic!() };
    assert_eq!(back.magnitude, -15.0);
}

fn unit() -> impl Strategy<Value = f64> {
    prop_oneof![8 => -1.0..=1.0_f64, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(-1.0)]
}

/// A record whose values fit the scales, from 16 reals.
fn record(kind: usize, u: [f64; 16]) -> Record {
    let s = SCALES;
    let point = |k: usize| [u[k % 16] * s.coordinate, u[(k + 5) % 16] * s.coordinate];
    match kind {
        0 | 1 => Record::Triangle(Triangle {
            corners: [point(0), point(1), point(2)],
            velocity: MeanVelocity::new([u[3] * s.velocity, u[4] * s.velocity]),
            stress: [u[5] * s.stress, u[6] * s.stress, u[7] * s.stress],
            damage: u[8],
            contact_force: (kind == 0).then_some([u[9] * s.force, u[10] * s.force]),
        }),
        2 => Record::FractureJoint(FractureJoint {
            nodes: [point(0), point(1), point(2), point(3)],
            failure_mode: u[4] * 2.0,
            normal_stress: u[5] * s.stress,
            shear_stress: u[6] * s.stress,
            sliding_force: u[7] * s.force,
            aperture: 10.0_f64.powf(-7.0 * u[8]),
            shear_displacement: u[9] * s.displacement,
            dilation: u[10] * s.displacement,
            hydraulic_aperture: 10.0_f64.powf(-7.0 * u[11]),
        }),
        3 => Record::BoundaryJoint(BoundaryJoint {
            nodes: [point(0), point(1), point(2), point(3)],
            contact_force: [u[4] * s.force, u[5] * s.force],
        }),
        _ => Record::AcousticSource(AcousticSource { position: point(0), magnitude: u[2] * 15.0 }),
    }
}

proptest! {
    /// Decoding gives the reals less at most one quantum, and text and integers come back.
    #[test]
    fn coded_reals_come_back_to_the_quantum(
        kind in 0..5_usize,
        units in prop::array::uniform16(unit()),
        digits in 1..=9_i64,
    ) {
        let digits = Digits::new(digits).unwrap();
        let record = record(kind, units);
        let coded = CodedRecord::encode(&record, digits, &SCALES);
        let again = CodedRecord::encode(&coded.decode(&SCALES), digits, &SCALES);
        prop_assert_eq!(coded.kind(), again.kind());
        // Rounding of the scaled values, in units of the digits; it shows from eight digits on.
        let slack = 1 + (1e-14 * digits.largest() as f64) as u64;
        for (a, b) in coded.numbers().iter().zip(again.numbers()) {
            prop_assert!(a.abs_diff(*b) <= slack, "{} {}", a, b);
        }
        let mut writer = SnapshotWriter::new(Vec::new(), digits, SCALES).unwrap();
        writer.write(&record).unwrap();
        let text = writer.into_inner();
        let snapshot = Snapshot::parse("a.ym", &text).unwrap();
        prop_assert_eq!(&snapshot.records[..], &[coded]);
        prop_assert_eq!(snapshot.to_bytes(), text);
    }

    /// A real is at most one quantum above what its number stands for, never below.
    #[test]
    fn truncation_is_less_than_a_quantum(value in -1.0..1.0_f64, digits in 1..=7_i64) {
        let digits = Digits::new(digits).unwrap();
        let back = digits.decode(digits.encode(value));
        let rounding = 4.0 * f64::EPSILON;
        prop_assert!(back <= value + rounding && value < back + digits.quantum() + rounding);
    }
}
