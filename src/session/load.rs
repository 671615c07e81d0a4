use crate::{
    TOLERANCE,
    insertion::{self, CapacityError, InsertionReport, Room},
    output::OutputNames,
    scene::{Profile, Scene, from_deck, spatial_from_deck},
    simulation::{AnySimulation, Simulation, SolverOptions, SpatialSimulation},
};
use std::{io, path::Path, path::PathBuf};
use thiserror::Error;
use yformat::{
    database::Database,
    deck::{Deck, ParseOutcome, Stage},
    diagnostic::Diagnostic,
    dialect::Dialect,
    source::SourceMap,
};

/// A deck whose first stage is ready to run.
#[derive(Debug)]
pub struct LoadedDeck {
    /// The deck.
    pub deck: Deck,
    /// Values after the items of the first stage.
    pub database: Database,
    /// Stages that end in `$YDOIT`; `None` where nothing runs.
    pub stages: Vec<Stage>,
    /// The first stage's simulation, meshed.
    pub simulation: Option<AnySimulation>,
    /// Warnings and notes.
    pub findings: Vec<Diagnostic>,
}

/// Why a deck cannot be run.
#[derive(Debug, Error)]
pub enum DeckFault {
    /// The file cannot be read.
    #[error("cannot read {path}: {source}")]
    Io {
        /// The deck.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The deck has errors.
    #[error("the deck has errors")]
    Findings {
        /// Sources that the findings point into.
        sources: Box<SourceMap>,
        /// All findings, errors among them.
        findings: Vec<Diagnostic>,
    },
}

/// Reads a deck and prepares its first stage, without touching any output file.
///
/// # Errors
/// If the file cannot be read, or with everything that is wrong with the deck.
pub fn load(
    path: &Path,
    dialect: Option<Dialect>,
    profile: Profile,
    options: SolverOptions,
) -> Result<LoadedDeck, DeckFault> {
    let outcome = yformat::deck::DeckReader::new()
        .dialect(dialect)
        .read(path)
        .map_err(|source| DeckFault::Io { path: path.to_path_buf(), source })?;
    prepare(outcome, path, profile, options)
}

/// Prepares the first stage of a deck that has been read, as [`load`] does. `path` is what the deck
/// is called; nothing is read there.
///
/// # Errors
/// With everything that is wrong with the deck.
pub fn prepare(
    outcome: ParseOutcome,
    path: &Path,
    profile: Profile,
    options: SolverOptions,
) -> Result<LoadedDeck, DeckFault> {
    let (deck, mut findings) = (outcome.deck, outcome.diagnostics);
    let sources = deck.sources();
    let stages: Vec<Stage> = deck.stages().into_iter().filter(|stage| stage.runs).collect();
    let mut database = Database::new(deck.dialect());
    let fault = |findings: Vec<Diagnostic>| {
        let findings = findings.into_iter().map(|f| f.located(sources)).collect();
        Err(DeckFault::Findings { sources: Box::new(sources.clone()), findings })
    };
    if findings.iter().any(Diagnostic::is_error) {
        return fault(findings);
    }
    let Some(first) = stages.first() else {
        let simulation = None;
        return Ok(LoadedDeck { database, stages, simulation, findings, deck });
    };
    for item in first.items.clone() {
        findings.extend(database.apply(&deck, item));
    }
    if findings.iter().any(Diagnostic::is_error) {
        return fault(findings);
    }
    let names = OutputNames::new(path, Path::new(""));
    let found = |finding| anchored(finding, &deck, first);
    let built = if is_spatial(&deck, &database) {
        let built =
            spatial_from_deck(&deck, &database, names.base(), profile, options.spatial_contact);
        findings.extend(built.findings.into_iter().map(found));
        built.scene.map(|scene| spatial(scene, options.clone()))
    } else {
        let built = from_deck(&deck, &database, names.base(), profile);
        findings.extend(built.findings.into_iter().map(found));
        built.scene.map(|scene| plane(scene, options.clone()))
    };
    let (simulation, report) = match built {
        Some(Ok(built)) => built,
        Some(Err(error)) => {
            let room = if is_spatial(&deck, &database) {
                let law = options.spatial_contact;
                let unmeshed =
                    spatial_from_deck(&deck, &database, names.base(), profile, law).scene;
                unmeshed.as_ref().and_then(insertion::room_needed_in_space)
            } else {
                let unmeshed = from_deck(&deck, &database, names.base(), profile).scene;
                unmeshed.as_ref().and_then(insertion::room_needed)
            };
            findings.push(capacity_finding(&deck, &database, &error, room));
            return fault(findings);
        }
        None => return fault(findings),
    };
    if report.is_some_and(|report| report.skipped_combination) {
        findings.push(skipped_record(&deck, &database, &simulation));
    }
    findings.extend(light_nodes(&deck, &database, &simulation));
    let findings = findings.into_iter().map(|f| f.located(sources)).collect();
    Ok(LoadedDeck { simulation: Some(simulation), database, stages, findings, deck })
}

/// Whether the deck is one in space that can be simulated.
fn is_spatial(deck: &Deck, database: &Database) -> bool {
    match deck.dialect() {
        Dialect::Split => database.integer("YDN/NNODIM") == 3,
        dialect => dialect == Dialect::Y3d,
    }
}

type Meshed = Result<(AnySimulation, Option<InsertionReport>), CapacityError>;

fn plane(scene: Scene, options: SolverOptions) -> Meshed {
    let mut simulation = Simulation::with_options(scene, options);
    simulation.prepare()?;
    let report = simulation.insertion_report();
    Ok((AnySimulation::Plane(Box::new(simulation)), report))
}

fn spatial(scene: Scene<3>, options: SolverOptions) -> Meshed {
    let mut simulation = SpatialSimulation::with_options(scene, options);
    simulation.prepare()?;
    let report = simulation.insertion_report();
    Ok((AnySimulation::Spatial(Box::new(simulation)), report))
}

/// The finding that a record of the meshing table does nothing.
fn skipped_record(deck: &Deck, database: &Database, simulation: &AnySimulation) -> Diagnostic {
    let place = database.given("YDPM/I2PMSET").and_then(|item| deck.word_span(item));
    Diagnostic::warning(
        "scene::mesh-record",
        "a record of I2PMSET does nothing: elements of its last material cannot be meshed",
    )
    .at(place)
    .expected(match simulation {
        AnySimulation::Plane(_) => {
            "elastic (1) or rigid (2) triangles as the last material of each record"
        }
        AnySimulation::Spatial(_) => "tetrahedra (21) as the last material of each record",
    })
}

/// The finding that nodes are too light to move: masses below an absolute tolerance count as none.
fn light_nodes(deck: &Deck, database: &Database, simulation: &AnySimulation) -> Option<Diagnostic> {
    let masses = match simulation {
        AnySimulation::Plane(simulation) => simulation.masses(),
        AnySimulation::Spatial(simulation) => simulation.masses(),
    };
    let is_light = |mass: f64| 0.0 < mass && mass <= TOLERANCE;
    let light = masses.iter().filter(|&&mass| is_light(mass)).count();
    let node = masses.iter().position(|&mass| is_light(mass))?;
    let more = if light > 1 { format!(" (and {} more)", light - 1) } else { String::new() };
    let density = match deck.dialect() {
        Dialect::Split | Dialect::YGeo => "YDPE/D1PERO",
        Dialect::Classic | Dialect::Y3d => "YDP/D1PERO",
    };
    Some(
        Diagnostic::warning(
            "scene::light-node",
            format!("node {node} has a mass of {:.3e}{more}: it never moves", masses[node]),
        )
        .at(database.given(density).and_then(|item| deck.word_span(item)))
        .expected(format!("masses above {TOLERANCE:e}, in whatever units the deck has"))
        .help("as in the original, lighter nodes count as without mass: write the deck with a smaller unit of mass or of length"),
    )
}

/// What the deck does not give has no place: it is missed at the stage's `$YDOIT`.
pub(super) fn anchored(finding: Diagnostic, deck: &Deck, stage: &Stage) -> Diagnostic {
    if finding.span.is_some() {
        return finding;
    }
    let run = stage.items.end.checked_sub(1).and_then(|item| deck.word_span(item));
    finding.at(run).label("not given up to here")
}

/// The finding that a mesh has no room for what is to be inserted. `room` is what it needs
/// altogether, where that is known.
pub(super) fn capacity_finding(
    deck: &Deck,
    database: &Database,
    error: &CapacityError,
    room: Option<Room>,
) -> Diagnostic {
    let name = if error.keyword == "MNOPO" { "YDN/MNOPO" } else { "YDE/MELEM" };
    let place = database.given(name).and_then(|item| deck.number_span(item, 0));
    let finding = Diagnostic::error(
        "scene::capacity",
        format!("{} leaves no room for {}", error.keyword, error.stage),
    )
    .at(place)
    .label(format!("room for {} {}", error.capacity, error.what));
    match room {
        Some(Room { nodes, elements }) => finding
            .expected(format!("MNOPO of {nodes} or more and MELEM of {elements} or more"))
            .help(format!("with all its joints and mid nodes the mesh has {nodes} nodes and {elements} elements")),
        None => finding
            .expected(format!("{} of {} or more", error.keyword, error.needed))
            .help(if database.integer("YDN/NNODIM") == 3 {
                format!("raise /YD/{name}; joints need 4 nodes for each tetrahedron and up to 4 more elements")
            } else {
                format!("raise /YD/{name}; joints need 3 nodes for each triangle and up to 3 more elements")
            }),
    }
}
