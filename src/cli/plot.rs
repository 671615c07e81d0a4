//! `ypsilon plot`: contour pictures of results, curves of histories and tables.

use super::{
    Exit,
    console::{say, warn},
    extract::ranges,
};
use clap::{Args, ValueEnum};
use std::path::{Path, PathBuf};
use ypsilon_converters::detect::{FileKind, detect_file};
use ypsilon_post::{
    PostError,
    field::Field,
    plot::{
        ColourMap, ContourOptions, Curve, CurveOptions, JointLines, Picture, Range, Scale, contour,
        curves_on,
    },
    results::{FrameChoice, Results},
    table::Table,
};

/// What is drawn of what, as the help shows it.
pub(super) const HELP: &str = "\
What the inputs hold decides what is drawn:
  .pvd, .vtu, d3plot family, folder with a .pvd   contour picture of a field
  .yh histories and .csv tables                   curves

Fields: von-mises, von-mises-plane (σzz = 0), tresca, sxx, syy, sxy, szz, s1, s2, s3,
  smax, smin, mean-stress, u, ux, uy, v, vx, vy, f, fx, fy, damage, material

Examples:
  ypsilon plot results/arch.pvd --field syy -o syy.png
  ypsilon plot results/arch.pvd --field u --time 0.02 --scale 10 --undeformed -o u.svg
  ypsilon plot results/arch.yh0 -o energy.png --y-label \"kinetic energy (J)\"
  ypsilon plot table.csv --x uy --y \"reaction y\" -o push.png

Exit codes:
  0    the picture is drawn
  1    the results cannot be read, or lack what is asked for
  2    the command line is wrong
  3    the picture cannot be written";

/// What to draw.
#[derive(Debug, Args)]
pub(super) struct PlotArguments {
    /// Results of one run, or histories and tables
    #[arg(required = true, value_name = "INPUT")]
    inputs: Vec<PathBuf>,
    /// The picture, .png or .svg
    #[arg(long, short, value_name = "FILE")]
    output: PathBuf,
    /// Width, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 1000)]
    width: u32,
    /// Title; without it the field and the time
    #[arg(long, value_name = "TEXT")]
    title: Option<String>,
    #[command(flatten)]
    contour: ContourArguments,
    #[command(flatten)]
    curves: CurveArguments,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Contour pictures")]
struct ContourArguments {
    /// Field to show
    #[arg(long, short, value_name = "FIELD", default_value = "von-mises")]
    field: String,
    /// Time in s (the nearest is taken), `#N` (from 0) or `last`
    #[arg(long, value_name = "TIME", default_value = "last")]
    time: String,
    /// Factor on displacements
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_hyphen_values = true)]
    scale: f64,
    /// Numbers that the colours cover, in Pa, m, m/s or N
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true, conflicts_with = "robust")]
    range: Option<String>,
    /// Leave out so many percent of the values at either end of the colours
    #[arg(long, value_name = "PERCENT", num_args = 0..=1, default_missing_value = "2")]
    robust: Option<f64>,
    /// Average stresses at the nodes and draw bands
    #[arg(long)]
    smooth: bool,
    /// Number of bands
    #[arg(long, value_name = "N", default_value_t = 16)]
    bands: usize,
    /// Colours [default: by the field]
    #[arg(long, value_enum, value_name = "MAP")]
    map: Option<Map>,
    /// Draw the edges of all triangles
    #[arg(long)]
    edges: bool,
    /// Draw the outline of the undeformed bodies
    #[arg(long)]
    undeformed: bool,
    /// Joints to draw
    #[arg(long, value_enum, value_name = "WHICH", default_value_t = Joints::Broken)]
    joints: Joints,
    /// Draw the unbroken joints of these joint sets too, as thin lines
    #[arg(long, value_delimiter = ',', value_name = "SET,...")]
    joint_sets: Vec<i32>,
    /// Part to show, m
    #[arg(long, value_name = "X0:X1,Y0:Y1", allow_hyphen_values = true)]
    window: Option<String>,
}

#[derive(Debug, Args)]
#[command(next_help_heading = "Curves")]
struct CurveArguments {
    /// Column along x, by name or number from 1 [default: the first]
    #[arg(long, value_name = "COLUMN")]
    x: Option<String>,
    /// Columns along y, by name or number from 1 [default: all others]
    #[arg(long, value_name = "COLUMN")]
    y: Vec<String>,
    /// Factor on the numbers along x
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_hyphen_values = true)]
    x_factor: f64,
    /// Factor on the numbers along y
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, allow_hyphen_values = true)]
    y_factor: f64,
    /// Label along x, the unit in brackets behind it
    #[arg(long, value_name = "TEXT")]
    x_label: Option<String>,
    /// Label along y, the unit in brackets behind it
    #[arg(long, value_name = "TEXT")]
    y_label: Option<String>,
    /// Part to show along x
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    x_range: Option<String>,
    /// Part to show along y
    #[arg(long, value_name = "LOW:HIGH", allow_hyphen_values = true)]
    y_range: Option<String>,
    /// Logarithmic axes; numbers that are not above 0 are left out
    #[arg(long, value_enum, value_name = "AXIS,...", value_delimiter = ',')]
    log: Vec<Axis>,
    /// Name of a curve in the legend, once for each
    #[arg(long, value_name = "TEXT")]
    name: Vec<String>,
    /// Mark the points
    #[arg(long)]
    markers: bool,
    /// Height, pixels
    #[arg(long, value_name = "PIXELS", default_value_t = 600)]
    height: u32,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Axis {
    X,
    Y,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Map {
    Viridis,
    CoolWarm,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Joints {
    None,
    /// Broken ones, coloured by how they failed
    Broken,
    /// Softening ones as well
    Damaged,
}

/// Draws a picture.
pub(super) fn main(arguments: &PlotArguments) -> Exit {
    let picture = match draw(arguments) {
        Ok(picture) => picture,
        Err(error) => return report(&error),
    };
    match picture.write(&arguments.output) {
        Ok(()) => {
            say(&format!("{}", arguments.output.display()));
            Exit::Done
        }
        Err(error) => report_writing(&error),
    }
}

/// Tells an error of reading or of the command line.
pub(super) fn report(error: &PostError) -> Exit {
    warn(&format!("error: {error}"));
    match error {
        PostError::Words { .. } => Exit::Usage,
        _ => Exit::Input,
    }
}

/// Tells an error of writing.
pub(super) fn report_writing(error: &PostError) -> Exit {
    warn(&format!("error: {error}"));
    match error {
        PostError::Words { .. } => Exit::Usage,
        _ => Exit::Output,
    }
}

fn draw(arguments: &PlotArguments) -> Result<Picture, PostError> {
    let ending = arguments.output.extension().and_then(|e| e.to_str()).unwrap_or_default();
    if !["png", "svg"].iter().any(|known| ending.eq_ignore_ascii_case(known)) {
        let found = arguments.output.display().to_string();
        return Err(PostError::words("the picture", found, "expected .png or .svg"));
    }
    match arguments.inputs.as_slice() {
        [results] if !is_table(results) => draw_contour(results, arguments),
        inputs => draw_curves(inputs, arguments),
    }
}

fn is_table(path: &Path) -> bool {
    let is_csv = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("csv"));
    is_csv || (path.is_file() && detect_file(path).is_ok_and(|kind| kind == FileKind::History))
}

fn draw_contour(input: &Path, arguments: &PlotArguments) -> Result<Picture, PostError> {
    let wanted = &arguments.contour;
    let range = match (&wanted.range, wanted.robust) {
        (Some(words), _) => Range::Fixed(ranges::<1>("the range", words)?[0]),
        (None, Some(percent)) => Range::Robust(percent),
        (None, None) => Range::Full,
    };
    let window = match &wanted.window {
        Some(words) => {
            let [x, y] = ranges::<2>("the window", words)?;
            Some([[x[0], y[0]], [x[1], y[1]]])
        }
        None => None,
    };
    let options = ContourOptions {
        map: wanted.map.map(|map| match map {
            Map::Viridis => ColourMap::Viridis,
            Map::CoolWarm => ColourMap::CoolWarm,
        }),
        range,
        deformation: wanted.scale,
        smooth: wanted.smooth,
        bands: wanted.bands,
        edges: wanted.edges,
        undeformed: wanted.undeformed,
        joints: match wanted.joints {
            Joints::None => JointLines::None,
            Joints::Broken => JointLines::Broken,
            Joints::Damaged => JointLines::Damaged,
        },
        joint_sets: wanted.joint_sets.clone(),
        window,
        width: arguments.width,
        title: arguments.title.clone(),
        ..ContourOptions::new(wanted.field.parse::<Field>()?)
    };
    let choice: FrameChoice = wanted.time.parse()?;
    let mut results = Results::open(input)?;
    let frame = results.frame(results.index_of(choice)?)?;
    contour(&frame, &options)
}

fn draw_curves(inputs: &[PathBuf], arguments: &PlotArguments) -> Result<Picture, PostError> {
    let wanted = &arguments.curves;
    let mut drawn = Vec::new();
    let (mut across, mut upwards) = (String::new(), Vec::new());
    for input in inputs {
        let table = Table::read(input)?;
        let x = wanted.x.as_deref().map_or(Ok(0), |name| table.find(name))?;
        let columns = if wanted.y.is_empty() {
            (0..table.headings.len()).filter(|&c| c != x).collect()
        } else {
            wanted.y.iter().map(|name| table.find(name)).collect::<Result<Vec<_>, _>>()?
        };
        let file = input.file_name().unwrap_or_default().to_string_lossy();
        for &column in &columns {
            let heading = table.headings.get(column).cloned().unwrap_or_default();
            let name = match (inputs.len(), columns.len()) {
                (1, _) => heading.clone(),
                (_, 1) => file.clone().into_owned(),
                _ => format!("{file}: {heading}"),
            };
            let name = wanted.name.get(drawn.len()).cloned().unwrap_or(name);
            let points = table.column(x).into_iter().zip(table.column(column));
            let points = points.map(|(x, y)| [x * wanted.x_factor, y * wanted.y_factor]);
            drawn.push(Curve { name, points: points.collect() });
            if across.is_empty() {
                across = table.headings.get(x).cloned().unwrap_or_default();
            }
            upwards.push(heading);
        }
    }
    let y = common_heading(&upwards);
    if y.starts_with('(') && wanted.name.is_empty() {
        // the axis tells the unit, with its prefix
        for curve in &mut drawn {
            if let Some(name) = curve.name.strip_suffix(&y) {
                curve.name = name.trim_end().to_owned();
            }
        }
    }
    let part = |what, words: &Option<String>| {
        words.as_deref().map(|words| ranges::<1>(what, words)).transpose()
    };
    let options = CurveOptions {
        title: arguments.title.clone().unwrap_or_default(),
        labels: [wanted.x_label.clone().unwrap_or(across), wanted.y_label.clone().unwrap_or(y)],
        ranges: [
            part("the range along x", &wanted.x_range)?.map(|[range]| range),
            part("the range along y", &wanted.y_range)?.map(|[range]| range),
        ],
        markers: wanted.markers,
        size: [arguments.width, wanted.height],
    };
    for factor in [wanted.x_factor, wanted.y_factor] {
        if !factor.is_finite() {
            return Err(PostError::words("the factor", factor.to_string(), "expected a number"));
        }
    }
    let scale = |axis| if wanted.log.contains(&axis) { Scale::Logarithmic } else { Scale::Linear };
    curves_on([Axis::X, Axis::Y].map(scale), &drawn, &options)
}

/// What columns that share an axis have in common: all, their unit in brackets, or nothing.
fn common_heading(headings: &[String]) -> String {
    let Some((first, others)) = headings.split_first() else { return String::new() };
    let unit = |heading: &str| heading.rfind('(').map(|at| heading[at..].to_owned());
    if others.iter().all(|heading| heading == first) {
        first.clone()
    } else if others.iter().all(|heading| unit(heading) == unit(first)) {
        unit(first).unwrap_or_default()
    } else {
        String::new()
    }
}
