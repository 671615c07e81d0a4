//! `ypsilon mesh`: decks from generators.

use super::{
    Exit,
    console::{say, warn},
};
use crate::{
    meshing::{
        AnyGenerated, Flag, MeshingError, Scenario, flags, picture, picture_in_space,
        scenario_from_flags,
    },
    session::write_generated,
};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, value_parser};
use std::path::PathBuf;

/// What is told below the help.
const HELP: &str = "\
Structures take their parameters as flags (`ypsilon mesh bridge --help`), from a scenario file
(`ypsilon mesh bridge.toml`), or both: flags win over the file.

Examples:
  ypsilon mesh bridge --arch-diameter-m 8.3 --load 'train' -o bridge.y --picture bridge.png
  ypsilon mesh bridge --print-scenario > bridge.toml
  ypsilon mesh bridge.toml -o bridge.y
  ypsilon mesh wall --scenario wall.toml --courses 9 -o small.y

Exit codes:
  0    the deck is written
  1    the scenario has errors or makes no sound mesh
  2    the command line is wrong
  3    the deck or picture cannot be written";

/// What to make, from clap's matches: flags follow from the scenarios' own parameters.
#[derive(Debug)]
pub(super) struct MeshArguments {
    scenario: Result<Scenario, MeshingError>,
    output: Option<PathBuf>,
    picture: Option<PathBuf>,
    print: bool,
    quiet: bool,
}

impl Args for MeshArguments {
    fn augment_args(command: Command) -> Command {
        let command = command
            .arg(
                Arg::new("file")
                    .value_name("SCENARIO")
                    .value_parser(value_parser!(PathBuf))
                    .help("Scenario file (.toml)"),
            )
            .subcommand_negates_reqs(true)
            .args_conflicts_with_subcommands(true)
            .arg_required_else_help(true)
            .subcommand_value_name("STRUCTURE")
            .subcommand_help_heading("Structures")
            .disable_help_subcommand(true)
            .after_help(HELP);
        let command = common(command);
        Scenario::KINDS
            .iter()
            .fold(command, |command, &(name, about)| command.subcommand(kind_command(name, about)))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

/// Flags of all ways to say what is wanted.
fn common(command: Command) -> Command {
    let path = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).value_name("FILE").value_parser(value_parser!(PathBuf)).help(help)
    };
    let switch = |name: &'static str, help: &'static str| {
        Arg::new(name).long(name).action(ArgAction::SetTrue).help(help)
    };
    command
        .arg(path("output", "The deck").short('o'))
        .arg(path("picture", "A picture of the mesh (.png, .svg)"))
        .arg(switch("print-scenario", "Print the scenario with all parameters, make no deck"))
        .arg(switch("quiet", "Print nothing but errors").short('q'))
}

fn kind_command(name: &'static str, about: &'static str) -> Command {
    let command = Command::new(name.replace('_', "-"))
        .about(about)
        .arg(
            Arg::new("scenario")
                .long("scenario")
                .value_name("FILE")
                .value_parser(value_parser!(PathBuf))
                .help("Scenario file that flags change"),
        )
        .arg(Arg::new("load").long("load").value_name("LOAD").action(ArgAction::Append).help(
            "Load, repeatable: `point force_n=1e6 x_m=0`, `distributed load_n_per_m=110e3`, \
                     `train`, `half-sine load_n_per_m=110e3`, `convoy`, `settlement side=left`; \
                     numbers of trains, convoys and settlements have the defaults of the thesis",
        ));
    flags(name).into_iter().fold(common(command), |command, flag| {
        let help = match &flag.default {
            Some(default) => format!("{} (default: {default})", flag.help),
            None => flag.help.clone(),
        };
        let argument = Arg::new(flag.name.clone()).long(flag.name).value_name("VALUE");
        command.arg(argument.help(help).allow_hyphen_values(true))
    })
}

impl FromArgMatches for MeshArguments {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let (scenario, own) = match matches.subcommand() {
            Some((kind, own)) => (from_flags(&kind.replace('-', "_"), own), own),
            None => {
                let file = matches.get_one::<PathBuf>("file");
                let none = || MeshingError::Scenario("no scenario file is given".to_owned());
                (file.ok_or_else(none).and_then(|file| Scenario::read(file)), matches)
            }
        };
        Ok(MeshArguments {
            scenario,
            output: own.get_one("output").cloned(),
            picture: own.get_one("picture").cloned(),
            print: own.get_flag("print-scenario"),
            quiet: own.get_flag("quiet"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

fn from_flags(kind: &str, matches: &ArgMatches) -> Result<Scenario, MeshingError> {
    let base = match matches.get_one::<PathBuf>("scenario") {
        None => None,
        Some(file) => {
            let scenario = Scenario::read(file)?;
            let (found, _) = scenario.kind()?;
            if found != kind {
                return Err(MeshingError::Scenario(format!(
                    "{} describes [{found}], not [{kind}]",
                    file.display()
                )));
            }
            Some(scenario)
        }
    };
    let values: Vec<(Flag, String)> = flags(kind)
        .into_iter()
        .filter_map(|flag| {
            let text = matches.get_one::<String>(&flag.name)?.clone();
            Some((flag, text))
        })
        .collect();
    let loads: Vec<String> =
        matches.get_many::<String>("load").into_iter().flatten().cloned().collect();
    scenario_from_flags(kind, base.as_ref(), &values, &loads)
}

/// Makes a deck.
pub(super) fn main(arguments: &MeshArguments) -> Exit {
    let scenario = match &arguments.scenario {
        Ok(scenario) => scenario,
        Err(error) => return fail(error),
    };
    if arguments.print {
        return match toml::to_string(scenario) {
            Ok(text) => {
                say(text.trim_end());
                Exit::Done
            }
            Err(error) => fail(&error),
        };
    }
    let generated = match scenario.generate_any() {
        Ok(generated) => generated,
        Err(error) => return fail(&error),
    };
    let Some(output) = &arguments.output else {
        warn("error: no file for the deck is given: -o FILE");
        return Exit::Usage;
    };
    if let Err(error) = write_generated(generated.deck(), output) {
        warn(&format!("error: {error}"));
        return Exit::Output;
    }
    if let Some(path) = &arguments.picture {
        let drawn = match &generated {
            AnyGenerated::Plane(generated) => picture(generated, 1200),
            AnyGenerated::Spatial(generated) => picture_in_space(generated, 1200),
        };
        if let Err(error) = drawn.and_then(|picture| picture.write(path)) {
            warn(&format!("error: {error}"));
            return Exit::Output;
        }
    }
    if !arguments.quiet {
        generated.report().iter().for_each(|line| say(line));
    }
    Exit::Done
}

fn fail(error: &dyn std::error::Error) -> Exit {
    warn(&format!("error: {error}"));
    Exit::Input
}
