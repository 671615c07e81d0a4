//! `ypsilon extract`: tables from results.

use super::{
    Exit,
    console::{say, warn},
    plot::{report, report_writing},
};
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use ypsilon_post::{
    Point, PostError,
    extract::{
        Path, Place, along, energy, extremes, force_displacement, histories, joint_counts, top_line,
    },
    field::Field,
    results::{FrameChoice, Results},
    selection::Selection,
    table::Table,
};

/// What the tables hold, as the help shows it.
pub(super) const HELP: &str = "\
Bodies are triangles in the plane, or tetrahedra in space: what is said of X,Y is then said of X,Y,Z

Selections (places at the start of the run):
  all, node:N, nodes:N,N,..., set:N (I1NOPR), material:N, body:N,
  box:X0:X1,Y0:Y1, in space box:X0:X1,Y0:Y1,Z0:Z1 (a bound may be left out),
  line:X0,Y0,X1,Y1, in space line:X0,Y0,Z0,X1,Y1,Z1

Fields: von-mises, tresca, sxx, syy, szz, sxy, s1, s2, s3, mean-stress, u, ux, uy, v, vx, vy,
  f, fx, fy, x, y, damage, material
  in the plane only: von-mises-plane (σzz = 0), smax, smin
  in space only: syz, szx, uz, vz, fz, z

Examples:
  ypsilon extract results/arch.pvd --what history --point 0,2.2 --fields uy,syy -o crown.csv
  ypsilon extract results/arch.pvd --what arch --centre 0,0 --radius 2.2 --angles 180:0 -o s.csv
  ypsilon extract results/wall.pvd --what force-displacement --support box:,:0.01 \\
      --moved line:0,1,1,1 -o push.csv
  ypsilon extract results/cube.pvd --what line --from 0,0,0 --to 0,0,1 --fields uz,szz -o z.csv

Exit codes:
  0    the table is written
  1    the results cannot be read, or lack what is asked for
  2    the command line is wrong
  3    the table cannot be written";

/// What to extract.
#[derive(Debug, Args)]
pub(super) struct ExtractArguments {
    /// Results of one run: .pvd, .vtu, d3plot family, or a folder with a .pvd
    results: PathBuf,
    /// What the table is to hold
    #[arg(long, value_enum, value_name = "WHAT")]
    what: What,
    /// The table, CSV; `-` prints it
    #[arg(long, short, value_name = "FILE", default_value = "-")]
    output: PathBuf,
    /// Fields [default: stresses on lines, displacements in histories]
    #[arg(long, value_delimiter = ',', value_name = "FIELD,...")]
    fields: Vec<String>,
    /// Times in s (the nearest is taken), `#N` (from 0) or `last`; `all` for all of them
    #[arg(long, value_delimiter = ',', value_name = "TIME,...", default_value = "last")]
    times: Vec<String>,
    /// Node of a history, from 0
    #[arg(long, value_name = "N")]
    node: Vec<usize>,
    /// Point of a history, m, in the undeformed bodies
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    point: Vec<String>,
    /// Point whose nearest node gives a history, m, in the undeformed bodies
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    nearest: Vec<String>,
    /// Where a line begins, m, in the undeformed bodies
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    from: Option<String>,
    /// Where it ends, m
    #[arg(long, value_name = "X,Y[,Z]", allow_hyphen_values = true)]
    to: Option<String>,
    /// Centre of an arch, m
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true)]
    centre: Option<String>,
    /// Radius of an arch, m
    #[arg(long, value_name = "R")]
    radius: Option<f64>,
    /// First and last angle of an arch, degrees: 0 points right, 90 up
    #[arg(long, value_name = "FROM:TO", default_value = "180:0", allow_hyphen_values = true)]
    angles: String,
    /// Samples on a line or an arch
    #[arg(long, value_name = "N", default_value_t = 101)]
    samples: usize,
    /// Nodes whose forces are summed
    #[arg(long, value_name = "SELECTION")]
    support: Option<String>,
    /// Nodes whose displacements are averaged
    #[arg(long, value_name = "SELECTION")]
    moved: Option<String>,
    /// Nodes of the top line [default: those that see the sky]
    #[arg(long, value_name = "SELECTION")]
    select: Option<String>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum What {
    /// Fields at nodes and points over time
    History,
    /// Kinetic energy over time
    Energy,
    /// Deformed upper edge at chosen times, in the plane
    TopLine,
    /// Fields along a straight line at chosen times
    Line,
    /// Fields along the arch coordinate s at chosen times, in the plane
    Arch,
    /// Reaction of supports against displacement
    ForceDisplacement,
    /// Smallest and largest values with place, over time
    Extremes,
    /// Joints intact, softening and broken over time
    Joints,
}

/// Extracts a table.
pub(super) fn main(arguments: &ExtractArguments) -> Exit {
    let table = match extract(arguments) {
        Ok(table) => table,
        Err(error) => return report(&error),
    };
    if arguments.output.as_os_str() == "-" {
        say(table.to_csv().trim_end());
        return Exit::Done;
    }
    match table.write(&arguments.output) {
        Ok(()) => {
            let (rows, columns) = (table.rows.len(), table.headings.len());
            warn(&format!("{}: {rows} rows, {columns} columns", arguments.output.display()));
            Exit::Done
        }
        Err(error) => report_writing(&error),
    }
}

fn extract(arguments: &ExtractArguments) -> Result<Table, PostError> {
    let asked = || -> Result<Vec<Field>, PostError> {
        arguments.fields.iter().map(|name| name.parse()).collect()
    };
    let given = |option: &'static str, words: &Option<String>| -> Result<String, PostError> {
        words.clone().ok_or_else(|| needed(arguments.what, option))
    };
    let selection = |option: &'static str,
                     words: &Option<String>|
     -> Result<Selection, PostError> { given(option, words)?.parse() };
    let point = |option: &'static str, words: &Option<String>| -> Result<Point, PostError> {
        Point::parse(option, &given(option, words)?)
    };
    match arguments.what {
        What::History => {
            let mut places: Vec<Place> = arguments.node.iter().map(|&n| Place::Node(n)).collect();
            for words in &arguments.point {
                places.push(Place::Point(Point::parse("--point", words)?));
            }
            for words in &arguments.nearest {
                places.push(Place::Nearest(Point::parse("--nearest", words)?));
            }
            if places.is_empty() {
                return Err(needed(
                    arguments.what,
                    "--node N, --point X,Y[,Z] or --nearest X,Y[,Z]",
                ));
            }
            let asked = asked()?;
            let mut results = Results::open(&arguments.results)?;
            let fields = fields(asked, [DISPLACEMENTS, DISPLACEMENTS_IN_SPACE], &mut results)?;
            histories(&mut results, &places, &fields)
        }
        What::Energy => energy(&mut Results::open(&arguments.results)?),
        What::Joints => joint_counts(&mut Results::open(&arguments.results)?),
        What::Extremes => {
            let asked = asked()?;
            let mut results = Results::open(&arguments.results)?;
            let fields = fields(asked, [STRESSES, STRESSES_IN_SPACE], &mut results)?;
            extremes(&mut results, &fields)
        }
        What::TopLine => {
            let selection = arguments.select.as_deref().map(str::parse).transpose()?;
            let mut results = Results::open(&arguments.results)?;
            let times = times(arguments, &results)?;
            top_line(&mut results, selection.as_ref(), &times)
        }
        What::Line | What::Arch => {
            let path = if arguments.what == What::Line {
                Path::Line([point("--from", &arguments.from)?, point("--to", &arguments.to)?])
            } else {
                let [angles] = ranges::<1>("--angles", &arguments.angles)?;
                let centre = centre(&given("--centre", &arguments.centre)?)?;
                let radius = arguments.radius.ok_or_else(|| needed(arguments.what, "--radius"))?;
                Path::Arc { centre, radius, angles }
            };
            let asked = asked()?;
            let mut results = Results::open(&arguments.results)?;
            let fields = fields(asked, [STRESSES, STRESSES_IN_SPACE], &mut results)?;
            let times = times(arguments, &results)?;
            along(&mut results, &path, arguments.samples, &fields, &times)
        }
        What::ForceDisplacement => {
            let support = selection("--support", &arguments.support)?;
            let moved = selection("--moved", &arguments.moved)?;
            force_displacement(&mut Results::open(&arguments.results)?, &support, &moved)
        }
    }
}

/// Fields of histories without `--fields`, of bodies in the plane.
const DISPLACEMENTS: &[Field] = &[Field::DisplacementX, Field::DisplacementY];
/// Of bodies in space.
const DISPLACEMENTS_IN_SPACE: &[Field] =
    &[Field::DisplacementX, Field::DisplacementY, Field::DisplacementZ];
/// Fields of lines and extremes without `--fields`, of bodies in the plane.
const STRESSES: &[Field] = &[Field::StressXx, Field::StressYy, Field::StressXy];
/// Of bodies in space.
const STRESSES_IN_SPACE: &[Field] = &[
    Field::StressXx,
    Field::StressYy,
    Field::StressZz,
    Field::StressXy,
    Field::StressYz,
    Field::StressZx,
];

/// The fields that were asked for, or those that there are without asking in the plane and in
/// space.
fn fields(
    asked: Vec<Field>,
    [plane, space]: [&[Field]; 2],
    results: &mut Results,
) -> Result<Vec<Field>, PostError> {
    match asked.is_empty() {
        false => Ok(asked),
        true => Ok(if results.dimension()? > 2 { space } else { plane }.to_vec()),
    }
}

/// The centre of an arch, in the plane.
fn centre(words: &str) -> Result<[f64; 2], PostError> {
    match Point::parse("--centre", words)? {
        Point::Plane(centre) => Ok(centre),
        Point::Space(_) => {
            let expected = "expected X,Y: an arch is one of bodies in the plane; in space there \
                            is --what line";
            Err(PostError::words("--centre", words, expected))
        }
    }
}

fn times(arguments: &ExtractArguments, results: &Results) -> Result<Vec<FrameChoice>, PostError> {
    if arguments.times == ["all"] {
        return Ok((0..results.len()).map(FrameChoice::Index).collect());
    }
    arguments.times.iter().map(|words| words.parse()).collect()
}

fn needed(what: What, option: &str) -> PostError {
    let name = what.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned());
    PostError::words("--what", name, format!("it needs {option}"))
}

/// `N` pairs `LOW:HIGH` with commas between them.
pub(super) fn ranges<const N: usize>(
    what: &'static str,
    words: &str,
) -> Result<[[f64; 2]; N], PostError> {
    let pair = |word: &str| {
        let (low, high) = word.split_once(':')?;
        let finite = |w: &str| w.trim().parse().ok().filter(|x: &f64| x.is_finite());
        Some([finite(low)?, finite(high)?])
    };
    let pairs: Option<Vec<[f64; 2]>> = words.split(',').map(pair).collect();
    pairs.and_then(|pairs| pairs.try_into().ok()).ok_or_else(|| {
        let expected = vec!["LOW:HIGH"; N].join(",");
        PostError::words(what, words, format!("expected {expected}"))
    })
}
