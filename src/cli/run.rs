use super::{
    Exit,
    console::{say, warn},
    deck_report, exit, interrupt,
    progress::Screen,
};
use crate::{
    output::{Monitor, MonitorPlan, OutputError, OutputNames},
    scene::{PressedFaces, Profile, SpatialContact},
    session::{
        Checkpoint, CheckpointError, Checkpoints, Format, OnInstability, RunError, RunOptions,
        RunSettings, ScenarioError, StopReason, Watch, deck_of_scenario, load, run_with,
    },
    simulation::{AnySimulation, SettlingFault, SettlingOptions, SolverOptions},
    team::Team,
};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use yformat::{diagnostic::Severity, dialect::Dialect};

/// Examples and exit codes, as the help shows them.
pub(super) fn help() -> String {
    format!(
        "\
Examples:
  ypsilon arch.y                              results beside the others in this folder, as the original does
  ypsilon run arch.y --out results            results in a folder of their own
  ypsilon run wall.y --settle --formats vtu   at rest first, results for ParaView only
  ypsilon run wall.y --out results --checkpoint-every 20000 --on-instability stop
  ypsilon run bridge.toml --out results --monitor crown=node:17:ux,uy

{}",
        exit::HELP
    )
}

/// What to run and what to write.
#[derive(Debug, Default, Args)]
pub(super) struct RunArguments {
    /// Input deck (`.y`), or scenario (`.toml`) whose deck is made into the folder of the results
    deck: PathBuf,
    /// Folder of the results, made if it does not exist
    #[arg(long = "out", value_name = "DIR", default_value = ".")]
    folder: PathBuf,
    /// Result files to write
    /// [default: native,vtu; with --resume those of the earlier run]
    #[arg(long, value_delimiter = ',', value_name = "LIST")]
    formats: Option<Vec<Format>>,
    /// Threads to compute with; results do not depend on it [default: all cores]
    #[arg(long, value_name = "N")]
    pub(super) threads: Option<usize>,
    /// Stop after so many steps, whatever the deck says
    #[arg(long, value_name = "N")]
    pub(super) steps: Option<u64>,
    /// Write the full-precision state after so many completed steps, as text
    #[arg(long, value_delimiter = ',', value_name = "N,N,...")]
    states: Vec<u64>,
    /// Bring the deck to rest under the loads of its first instant before the first step, by
    /// dynamic relaxation: many times faster than waiting for it. Results then begin with the
    /// settled state
    #[arg(long, conflicts_with = "resume")]
    settle: bool,
    /// Unbalanced force ratio at which the deck counts as settled: largest residual nodal force
    /// over mean nodal load
    #[arg(long, value_name = "RATIO", requires = "settle", default_value_t = SettlingOptions::TOLERANCE)]
    settle_tolerance: f64,
    /// Iterations after which settling is given up
    #[arg(long, value_name = "N", requires = "settle",
          value_parser = clap::value_parser!(u64).range(1..),
          default_value_t = SettlingOptions::MOST_ITERATIONS)]
    settle_steps: u64,
    /// Write DECK.checkpoint when the run ends, also when Ctrl-C or --steps ends it:
    /// --resume goes on from there
    #[arg(long)]
    checkpoint: bool,
    /// The same, and after every N steps (for runs that may be killed)
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub(super) checkpoint_every: Option<u64>,
    /// Go on from a checkpoint of the same deck and version, in the folder of its results
    /// (DECK.checkpoint there, if no file is given): all results are as if the run had
    /// never stopped. Of the deck only MCSTEP may have changed, to make a finished run
    /// longer. Writes checkpoints like --checkpoint
    #[arg(long, value_name = "FILE", num_args = 0..=1, require_equals = true)]
    resume: Option<Option<PathBuf>>,
    /// Watch sums over nodes: NAME=SELECTION:QUANTITY[,QUANTITY...], such as
    /// support=set:1:reaction-x,reaction-y; written to BASE.monitors.csv. Selections: all,
    /// nodes:N,N, set:N, box:X0:X1,Y0:Y1, line:X0,Y0,X1,Y1, material:N, body:N
    #[arg(long = "monitor", value_name = "MONITOR", conflicts_with = "resume")]
    monitors: Vec<Monitor>,
    /// Steps between two lines of the monitors
    /// [default: 100, or what the scenario says]
    #[arg(long = "monitor-every", value_name = "N", conflicts_with = "resume",
          value_parser = clap::value_parser!(u64).range(1..))]
    monitor_interval: Option<u64>,
    /// Watch where the energy is and where it goes: BASE.energy.csv with a line every N steps
    /// [default: 100], the balance and its error in the summary. Up to ten times slower
    #[arg(long, value_name = "N", num_args = 0..=1, require_equals = true,
          default_missing_value = "100", value_parser = clap::value_parser!(u64).range(1..),
          conflicts_with = "resume")]
    energy: Option<u64>,
    /// Error of the balance of energies, by the largest energy so far, beyond which the motion makes no
    /// sense any more
    #[arg(long, value_name = "RATIO", requires = "energy", default_value_t = Watch::ENERGY_LIMIT,
          value_parser = parse_ratio)]
    energy_limit: f64,
    /// What to do when the motion makes no sense any more (no numbers, elements inside out, nodes ten
    /// times as fast as waves, energies off by a tenth with --energy): say so and go on, or stop at
    /// the first such step with a state, VTU files and a checkpoint just before it
    /// [default: say so, and stop when there are no numbers; with --resume as in the earlier run]
    #[arg(long, value_enum, value_name = "WHAT")]
    on_instability: Option<InstabilityName>,
    /// Write the d3plot header exactly as the original did (today's readers
    /// other than LS-PrePost refuse it)
    #[arg(long, conflicts_with = "resume")]
    legacy_d3plot: bool,
    /// Take the deck for one of this dialect instead of recognising it
    #[arg(long, value_name = "NAME", value_parser = parse_dialect, conflicts_with = "resume")]
    dialect: Option<Dialect>,
    /// Program to follow where the two originals of the split dialect differ
    /// [default: windows]
    #[arg(long, value_enum, conflicts_with = "resume")]
    profile: Option<ProfileName>,
    /// Faces of touching tetrahedra that are pressed, in decks in three dimensions
    /// [default: one-sided]
    #[arg(long, value_enum, conflicts_with = "resume")]
    contact: Option<ContactName>,
    /// Let tetrahedra rub: Coulomb friction with D1PEFR and D1PEPT, in decks in three dimensions
    #[arg(long, conflicts_with = "resume")]
    contact_friction: bool,
    /// Evaluate every couple in every step (slower, same results)
    #[arg(long, hide_short_help = true)]
    no_skip: bool,
    /// End the run as Ctrl-C does when the standard input ends: whoever started it has gone
    #[arg(long, hide = true)]
    stop_at_eof: bool,
    /// Print nothing but errors
    #[arg(long, short)]
    pub(super) quiet: bool,
}

/// The two originals of the split dialect.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ProfileName {
    /// The Windows program
    Windows,
    /// The published source: local axes are normalised, joints between tetrahedra open contact where they fail
    Source,
}

impl From<ProfileName> for Profile {
    fn from(name: ProfileName) -> Self {
        match name {
            ProfileName::Windows => Self::Windows,
            ProfileName::Source => Self::Source,
        }
    }
}

/// What to do about instability.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum InstabilityName {
    /// Say so once and go on
    Warn,
    /// Stop at the first step that makes no sense
    Stop,
}

impl From<InstabilityName> for OnInstability {
    fn from(name: InstabilityName) -> Self {
        match name {
            InstabilityName::Warn => Self::Warn,
            InstabilityName::Stop => Self::Stop,
        }
    }
}

/// Laws of contact of tetrahedra.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ContactName {
    /// The original's: faces of the element with the higher number
    OneSided,
    /// Faces of both, from a potential: energy is kept, and numbering decides about nothing
    TwoSided,
}

impl From<ContactName> for PressedFaces {
    fn from(name: ContactName) -> Self {
        match name {
            ContactName::OneSided => Self::Contactor,
            ContactName::TwoSided => Self::Both,
        }
    }
}

fn parse_ratio(words: &str) -> Result<f64, String> {
    let ratio: Option<f64> = words.parse().ok().filter(|ratio| *ratio > 0.0);
    ratio.ok_or_else(|| format!("`{words}` is no ratio: expected a number above 0, such as 0.01"))
}

pub(super) fn parse_dialect(name: &str) -> Result<Dialect, String> {
    name.parse().map_err(|_| {
        let names: Vec<&str> = Dialect::ALL.iter().map(|d| d.name()).collect();
        format!("there is no dialect `{name}`; there are {}", names.join(", "))
    })
}

impl RunArguments {
    /// A run of a deck as [`go_on`] takes it.
    pub(super) fn of(deck: PathBuf, folder: PathBuf) -> Self {
        Self { deck, folder, ..Self::default() }
    }

    /// The dialect that the deck is taken for, if it is said.
    pub(super) fn dialect(&self) -> Option<Dialect> {
        self.dialect
    }

    /// How to settle, if the deck is to be settled.
    fn settling(&self) -> Option<SettlingOptions> {
        self.settle.then_some(SettlingOptions {
            tolerance: self.settle_tolerance,
            most_iterations: self.settle_steps,
        })
    }

    /// The law of contact of tetrahedra.
    fn spatial_contact(&self) -> SpatialContact {
        SpatialContact {
            pressed: self.contact.map(PressedFaces::from).unwrap_or_default(),
            has_friction: self.contact_friction,
        }
    }

    /// The checkpoint to go on from.
    fn earlier(&self, deck: &Path) -> Result<Option<Checkpoint>, CheckpointError> {
        let file = |given: &Option<PathBuf>| {
            let own = || OutputNames::new(deck, &self.folder).checkpoint();
            given.clone().unwrap_or_else(own)
        };
        self.resume.as_ref().map(|given| Checkpoint::read(&file(given))).transpose()
    }

    /// The deck to run; that of a scenario is made now.
    fn deck_and_monitors(&self) -> Result<(PathBuf, MonitorPlan), ScenarioError> {
        if self.deck.extension().is_none_or(|ending| ending != "toml") {
            return Ok((self.deck.clone(), MonitorPlan::default()));
        }
        let made = deck_of_scenario(&self.deck, &self.folder)?;
        if !self.quiet {
            made.generated.report().iter().for_each(|line| say(line));
        }
        Ok((made.path, made.monitors))
    }

    /// What is watched: the scenario's monitors, then those of the command line.
    fn plan(&self, of_scenario: MonitorPlan) -> MonitorPlan {
        let mut plan = of_scenario;
        plan.monitors.extend(self.monitors.iter().cloned());
        plan.interval = self.monitor_interval.unwrap_or(plan.interval);
        plan
    }

    /// What is asked for; what is not said is as in the earlier run.
    fn settings(&self, earlier: Option<&Checkpoint>, of_scenario: MonitorPlan) -> RunSettings {
        let given = |dialect: Dialect| dialect.name().to_owned();
        let profile = self.profile.map(Profile::from);
        let on_instability = self.on_instability.map(OnInstability::from);
        match earlier.map(Checkpoint::settings) {
            None => RunSettings {
                formats: self.formats.clone().unwrap_or(vec![Format::Native, Format::Vtu]),
                states: self.states.clone(),
                legacy_d3plot: self.legacy_d3plot,
                profile: profile.unwrap_or_default(),
                dialect: self.dialect.map(given),
                spatial_contact: self.spatial_contact(),
                monitors: self.plan(of_scenario),
                watch: Watch {
                    energy_interval: self.energy,
                    energy_limit: self.energy_limit,
                    on_instability: on_instability.unwrap_or_default(),
                },
            },
            Some(earlier) => RunSettings {
                formats: self.formats.clone().unwrap_or_else(|| earlier.formats.clone()),
                states: match self.states.is_empty() {
                    true => earlier.states.clone(),
                    false => self.states.clone(),
                },
                watch: Watch {
                    on_instability: on_instability.unwrap_or(earlier.watch.on_instability),
                    ..earlier.watch.clone()
                },
                // what decides about bits is not to be changed halfway
                ..earlier.clone()
            },
        }
    }
}

/// Runs a deck.
pub(super) fn main(arguments: &RunArguments) -> Exit {
    start(arguments, None)
}

/// Goes on with a run of a deck from a checkpoint.
pub(super) fn go_on(arguments: &RunArguments, checkpoint: Checkpoint) -> Exit {
    start(arguments, Some(checkpoint))
}

fn start(arguments: &RunArguments, checkpoint: Option<Checkpoint>) -> Exit {
    if arguments.threads == Some(0) {
        warn("error: --threads needs at least 1");
        return Exit::Usage;
    }
    let team = match arguments.threads.map_or_else(Team::of_all_cores, Team::new) {
        Ok(team) => team,
        Err(error) => {
            warn(&format!("error: cannot start the threads: {error}"));
            return Exit::Usage;
        }
    };
    let (deck, scenario_monitors) = match arguments.deck_and_monitors() {
        Ok(found) => found,
        Err(error) => {
            warn(&format!("error: {error}"));
            return match error {
                ScenarioError::Meshing { .. } | ScenarioError::Monitor { .. } => Exit::Input,
                ScenarioError::Foreign(_) | ScenarioError::Io { .. } => Exit::Output,
            };
        }
    };
    let resume = match checkpoint.map_or_else(|| arguments.earlier(&deck), |found| Ok(Some(found)))
    {
        Ok(resume) => resume,
        Err(error) => return report_failure(&error.into()),
    };
    let settings = arguments.settings(resume.as_ref(), scenario_monitors);
    let dialect = settings.dialect.as_deref().and_then(|name| name.parse::<Dialect>().ok());
    let solver = SolverOptions {
        skip_separated_couples: !arguments.no_skip,
        spatial_contact: settings.spatial_contact,
        team,
    };
    let loaded = match load(&deck, dialect, settings.profile, solver) {
        Ok(loaded) => loaded,
        Err(fault) => return deck_report::print_fault(&fault, arguments.quiet),
    };
    if let Some(AnySimulation::Plane(_)) = &loaded.simulation
        && settings.spatial_contact != SpatialContact::default()
    {
        warn(&format!(
            "error: --contact and --contact-friction choose how tetrahedra touch, but {} is a deck \
             in the plane (NNODIM 2): leave them out. Triangles always press each other's edges, \
             with the friction of the deck",
            deck.display()
        ));
        return Exit::Usage;
    }
    interrupt::install();
    if arguments.stop_at_eof {
        interrupt::watch_input();
    }
    let options = RunOptions {
        deck,
        folder: arguments.folder.clone(),
        formats: settings.formats,
        states: settings.states,
        steps: arguments.steps,
        legacy_d3plot: settings.legacy_d3plot,
        monitors: settings.monitors,
        watch: settings.watch,
        profile: settings.profile,
        settling: arguments.settling(),
    };
    let every = arguments.checkpoint_every;
    let checkpoints = Checkpoints {
        at_end: arguments.checkpoint || every.is_some() || resume.is_some(),
        every,
        dialect: settings.dialect,
        spatial_contact: settings.spatial_contact,
        resume,
    };
    let outcome = if arguments.quiet {
        run_with(loaded, &options, checkpoints, &mut Quiet)
    } else {
        run_with(loaded, &options, checkpoints, &mut Screen::new())
    };
    match outcome {
        Ok(summary) if summary.stop == StopReason::Interrupted => Exit::Interrupted,
        Ok(_) => Exit::Done,
        Err(error) => report_failure(&error),
    }
}

/// Says nothing, but stops when asked to.
struct Quiet;

impl crate::session::Observer for Quiet {
    fn wants_stop(&self) -> bool {
        interrupt::is_requested()
    }
}

fn report_failure(error: &RunError) -> Exit {
    if let RunError::Stage { sources, findings } = error {
        deck_report::print(findings, sources, Severity::Warning);
    }
    warn(&format!("error: {error}"));
    match error {
        RunError::Output(OutputError::Monitor { .. } | OutputError::MonitorInSpace { .. }) => {
            Exit::Usage
        }
        RunError::Output(_) => Exit::Output,
        RunError::Settling(SettlingFault::Tolerance(_)) => Exit::Usage,
        RunError::Settling(SettlingFault::Refused(_)) => Exit::Input,
        RunError::Unstable { .. } | RunError::Instability { .. } | RunError::Settling(_) => {
            Exit::Unstable
        }
        RunError::Stage { .. } | RunError::Checkpoint(_) => Exit::Input,
    }
}
