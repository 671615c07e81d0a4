//! Bridges under their own weight.

use super::{
    family::{ALL, BridgeRun, SETTLED, asymmetry, middles, run_one, run_shown},
    pictures,
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome};
use ypsilon_post::{field::Field, results::Frame};

/// The case.
pub(super) const CASE: Case = Case {
    name: "self-weight",
    group: Group::Bridges,
    title: "Bridges under their own weight",
    source: "thesis, section 4.3.1, figures 4.5 and 4.6",
    about: "\
Length 16.6 m, height 9 m, arch diameter D = 0.25 L, 0.5 L and 0.75 L, centre 0.3 R above the ground, on
clamped footings between soil that is clamped on its far side. Stone E = 25 GPa, ν = 0.2, ρ = 2400 kg/m³;
soil E = 0.24 GPa, ρ = 1800 kg/m³; mortar f_t = 0.2 MPa, G_f = 0.5 N/m, penalty 8 GPa; inside blocks
f_t = 3 MPa, G_f = 7.5 N/m, penalty 141 GPa; contact penalties 10 and 5 GPa, friction 0.57; time step 5 µs.
The thesis does not tell the thickness of the ring (0.45 m here), the height of the courses (0.6 m, 15 of
them) or the width of the soil (2 m). Blocks of a course lie half a block beside those below, and the corners of neighbours
are shared, so that most blocks have four triangles: 1928, 1520 and 905 of them (the thesis: 2066, 1124 and 606,
two for each block). The number of nodes on the top line is the thesis's.

Gravity comes at t = 0; the bridges are at rest by 1.5 s. The mesh is exactly mirror-symmetric.",
    evaluate,
};

/// Weight of a column as high as the masonry, by area \[MPa\].
const COLUMN: f64 = 2400.0 * 9.81 * 9.0 / 1e6;

/// Why a factor of two is granted.
const FACTOR: &str = "\
The largest compression is that of one triangle at the corner where the masonry ends on the clamped ground, so it
depends on the size of the lowest block and on what the soil takes: blocks and triangles of the thesis are not \
told. The mean over the base follows from statics and agrees.";

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut findings = Vec::new();
    let mut runs = run_shown(bench)?;
    let mut largest = Vec::new();
    let mut energies = Vec::new();
    for run in &mut runs {
        let label = run.label;
        let frame = run.last()?;
        let (compression, _) = run.compression(&frame);
        largest.push(compression);
        if bench.length() == Length::Full {
            findings.push(
                Finding::range(
                    &format!("largest compression σyy, {label}"),
                    "MPa",
                    [COLUMN, 0.83 * 2.0],
                    compression / 1e6,
                )
                .noted(
                    "From the weight of a column as high as the masonry, which the arch makes larger at the footings, \
                     to twice the end of the thesis's colours. The three pictures of its figure 4.6 share them, so \
                     that 0.83 MPa is one bridge's, by its text that with D = 0.5 L.",
                ),
            );
        }
        findings.push(place(run, &frame));
        findings.push(weight_finding(run)?);
        let asymmetry = asymmetry(&frame).unwrap_or(f64::NAN);
        findings.push(
            Finding::range(
                &format!("asymmetry of σyy with contact between blocks, {label}"),
                "of the largest",
                [0.0, 1e-3],
                asymmetry,
            )
            .noted(
                "Rounding: sums run in the order of triangles and couples, which is not mirrored. It takes more than a \
                 symmetric mesh: joints evaluate their three points one after the other, each with the shear strength \
                 that the one before left, so images of joints have to begin with the other triangle. The generator \
                 numbers the right half backwards for that; numbered forwards, the asymmetry is 5e-3 once mortar softens.",
            ),
        );
        let history = energy(run)?;
        let peak = history.iter().map(|p| p[1]).fold(0.0, f64::max);
        let end = history.last().map_or(f64::NAN, |p| p[1]);
        if bench.length() == Length::Full {
            findings.push(Finding::range(
                &format!("kinetic energy at {SETTLED} s, {label}"),
                "of its peak",
                [0.0, 1e-6],
                end / peak,
            ));
        }
        energies.push((label.to_owned(), logarithms(&history)));
    }
    for &(name, label) in bench.pick(&ALL[..], &ALL[2..]) {
        let mut run = run_one(bench, &format!("without-contact-{name}"), label)?;
        let frame = run.last()?;
        findings.push(Finding::range(
            &format!("asymmetry of σyy without contact, {label}"),
            "of the largest",
            [0.0, 1e-7],
            asymmetry(&frame).unwrap_or(f64::NAN),
        ));
    }
    let mut pictures = Vec::new();
    if bench.length() == Length::Full {
        let middle_is_worst = largest[1] > largest[0] && largest[1] > largest[2];
        let order = format!(
            "{:.2}, {:.2} and {:.2} MPa for D = 0.25 L, 0.5 L and 0.75 L",
            largest[0] / 1e6,
            largest[1] / 1e6,
            largest[2] / 1e6
        );
        findings.push(
            Finding::statement(
                "bridge with the largest compression",
                "D = 0.5 L",
                &order,
                middle_is_worst,
            )
            .noted(if middle_is_worst { "" } else { FACTOR }),
        );
        findings.push(
            Finding::range(
                "largest compression σyy of the three bridges",
                "MPa",
                [0.83 / 2.0, 0.83 * 2.0],
                largest.iter().copied().fold(0.0, f64::max) / 1e6,
            )
            .noted(FACTOR),
        );
        pictures = pictures::stresses(
            bench,
            &mut runs,
            Field::StressYy,
            SETTLED,
            "σyy under self weight",
        )?;
        let caption = "Kinetic energy: every bridge is at rest by 1.5 s (figure 4.5)";
        let labels = ["time (s)", "decimal logarithm of the kinetic energy in J"];
        pictures.push(pictures::lines(bench, energies, labels, "energy.png", caption)?);
    }
    Ok(Outcome { findings, pictures })
}

/// Steps of the thesis's colours (1.66 of 8.30): what its pictures can tell apart.
const COLOUR: f64 = 0.2;

/// The largest compression is at the bottom of the footings, which is the course on the ground, as far
/// as the thesis's colours tell.
fn place(run: &BridgeRun, frame: &Frame) -> Finding {
    let (largest, [x, y]) = run.compression(frame);
    let course = run.bridge.height_m / run.bridge.courses as f64;
    let stress = frame.stress.as_deref().unwrap_or_default();
    let bottom = stress
        .iter()
        .zip(middles(frame))
        .filter(|(_, at)| at[1] < course && at[0].abs() < run.half_length())
        .map(|(s, _)| -s[1])
        .fold(0.0, f64::max);
    Finding::statement(
        &format!("place of the largest compression, {}", run.label),
        "bottom of the footing, within one of the thesis's five colours",
        &format!(
            "{:.3} MPa there, {:.3} MPa at most (x = {x:.2} m, y = {y:.2} m)",
            bottom / 1e6,
            largest / 1e6
        ),
        bottom >= (1.0 - COLOUR) * largest,
    )
}

/// The ground carries what the soil does not.
fn weight_finding(run: &BridgeRun) -> Result<Finding, CaseError> {
    let model = &run.run.generated.model;
    let weight: f64 = model
        .mesh
        .triangles
        .iter()
        .filter(|t| model.substances[t.material].name == "stone")
        .map(|t| 2400.0 * model.mesh.area(t) * 9.81)
        .sum();
    let end = run.run.summary.time;
    let quantity = format!("share of the masonry's weight on the ground, {}", run.label);
    Ok(Finding::range(&quantity, "", [0.8, 1.0], run.ground(end / 2.0, end)? / weight).noted(
        "Mean over the second half of the time. The weight of the nodes on the ground is in no reaction. The soil beside \
         the masonry carries some of it by friction or hangs some of its own on it: as soft as it is, it shortens by 3 mm \
         under its weight, the masonry by 0.04 mm.",
    ))
}

/// The history of the kinetic energy.
fn energy(run: &BridgeRun) -> Result<Vec<[f64; 2]>, CaseError> {
    let table = run.run.monitors()?;
    let (time, energy) = (table.find("time")?, table.find("all kinetic-energy")?);
    Ok(table.rows.iter().map(|row| [row[time], row[energy]]).collect())
}

fn logarithms(history: &[[f64; 2]]) -> Vec<[f64; 2]> {
    history.iter().filter(|p| p[1] > 0.0).map(|&[t, e]| [t, e.log10()]).collect()
}
