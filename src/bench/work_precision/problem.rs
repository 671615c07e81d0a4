//! Problems with answers, and how they are solved.

use super::{
    recommendations::Purpose,
    settings::{Parameter, Settings},
};
use crate::{
    bench::BenchError,
    contact::CoupleWork,
    meshing::{Generated, Material, Scenario, SpatialGenerated, TimeStepBounds},
    scene::{BuildOutcome, Profile, Scene, SpatialContact, from_deck, spatial_from_deck},
    simulation::{Simulation, SolverOptions, SpatialSimulation},
};
use std::time::Instant;
use yformat::{database::Database, deck::Deck};

/// A problem whose answer is known.
pub trait Problem {
    /// Name in file names and on the command line.
    fn name(&self) -> &'static str;

    /// What it is, in one line.
    fn title(&self) -> &'static str;

    /// What its error is.
    fn error_is(&self) -> &'static str;

    /// What is varied, with the values where they are not the [usual](Parameter::values) ones.
    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])>;

    /// What runs like it are made for.
    fn purpose(&self) -> Purpose;

    /// Settings that stay while a parameter is varied; those of the generator without them.
    fn base(&self, _varied: Parameter) -> Settings {
        Settings::default()
    }

    /// The scenario, with so many times the cells of the coarsest mesh along an edge.
    fn scenario(&self, refinement: usize) -> Scenario;

    /// The material that bodies of the scenario have.
    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material>;

    /// How it is solved: steps through the problem and gives its error, by the answer.
    fn answer(&self) -> Answer<'_>;
}

/// What a problem brings with it.
pub enum Answer<'a> {
    /// In the plane.
    Plane(&'a dyn InPlane),
    /// In space.
    Space(&'a dyn InSpace),
}

/// A problem of triangles.
pub trait InPlane {
    /// Changes what a scenario cannot say.
    fn start(&self, _scene: &mut Scene) {}

    /// Steps through the problem and gives its error, by the answer.
    fn error(&self, run: &mut Run<'_>) -> f64;
}

/// A problem of tetrahedra.
pub trait InSpace {
    /// The law of contact.
    fn contact(&self) -> SpatialContact {
        SpatialContact::default()
    }

    /// Changes what a scenario cannot say.
    fn start(&self, _scene: &mut Scene<3>) {}

    /// Steps through the problem and gives its error, by the answer.
    fn error(&self, run: &mut SpatialRun<'_>) -> f64;
}

/// What is stepped through.
pub trait Stepped {
    /// Does a step.
    fn step(&mut self);

    /// Kinetic energy, J.
    fn kinetic_energy(&self) -> f64;

    /// Triangles or tetrahedra.
    fn bodies(&self) -> usize;

    /// Contact work.
    fn contact_work(&self) -> CoupleWork;
}

impl Stepped for Simulation {
    fn step(&mut self) {
        self.evaluate_forces();
        self.advance();
    }

    fn kinetic_energy(&self) -> f64 {
        self.sum_kinetic_energy()
    }

    fn bodies(&self) -> usize {
        self.triangles().count()
    }

    fn contact_work(&self) -> CoupleWork {
        self.couple_work().unwrap_or_default()
    }
}

impl Stepped for SpatialSimulation {
    fn step(&mut self) {
        self.evaluate_forces();
        self.advance();
    }

    fn kinetic_energy(&self) -> f64 {
        self.sum_kinetic_energy()
    }

    fn bodies(&self) -> usize {
        self.tetrahedra().count()
    }

    fn contact_work(&self) -> CoupleWork {
        self.couple_work().unwrap_or_default()
    }
}

/// A problem in space that is being solved.
pub type SpatialRun<'a> = Run<'a, SpatialSimulation, SpatialGenerated>;

/// A problem that is being solved.
#[derive(Debug)]
pub struct Run<'a, S = Simulation, G = Generated> {
    /// What the generator made.
    pub made: &'a G,
    /// The simulation, before its first step.
    pub simulation: S,
    /// Steps to the end of the problem.
    pub steps: u64,
    /// Steps done.
    pub done: u64,
}

impl<S: Stepped, G> Run<'_, S, G> {
    /// Does a step. `false` at the end, or when nothing is finite any more.
    pub fn step(&mut self) -> bool {
        let is_over = self.done >= self.steps
            || (self.done.is_multiple_of(64) && !self.simulation.kinetic_energy().is_finite());
        if is_over {
            return false;
        }
        self.simulation.step();
        self.done += 1;
        true
    }

    /// Does all steps.
    pub fn finish(&mut self) {
        while self.step() {}
    }

    /// Solves the problem.
    fn solved(mut self, error: impl FnOnce(&mut Self) -> f64) -> Outcome {
        let started = Instant::now();
        let error = error(&mut self);
        let seconds = started.elapsed().as_secs_f64();
        let is_sound = error.is_finite() && error < ABSURD && self.done == self.steps;
        Outcome {
            error: if is_sound { error } else { f64::NAN },
            seconds,
            steps: self.steps,
            bodies: self.simulation.bodies(),
            work: self.simulation.contact_work(),
        }
    }
}

/// What stepping through a problem came to.
struct Outcome {
    error: f64,
    seconds: f64,
    steps: u64,
    bodies: usize,
    work: CoupleWork,
}

impl Run<'_> {
    /// Mean displacement of nodes whose place fulfils a condition, weighted by mass, m.
    #[must_use]
    pub fn displacement(&self, holds: impl Fn([f64; 2]) -> bool) -> [f64; 2] {
        let nodes = &self.simulation.scene().nodes;
        let (mut sum, mut mass) = ([0.0; 2], 0.0);
        for (n, (start, now)) in nodes.initial.iter().zip(&nodes.current).enumerate() {
            if holds([start.x, start.y]) {
                let m = self.simulation.masses()[n];
                mass += m;
                sum = [sum[0] + m * (now.x - start.x), sum[1] + m * (now.y - start.y)];
            }
        }
        sum.map(|s| s / mass)
    }
}

/// What solving a problem came to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Error by the answer; NaN if the run became unstable.
    pub error: f64,
    /// Wall-clock time of the steps, s.
    pub seconds: f64,
    /// Steps to the end.
    pub steps: u64,
    /// Triangles or tetrahedra.
    pub triangles: usize,
    /// Contact detections.
    pub detections: u64,
    /// Couples evaluated, summed over steps.
    pub couples: u64,
    /// Time step, s.
    pub step_s: f64,
    /// Contact penalty, Pa.
    pub penalty_pa: f64,
    /// DIEZON, m.
    pub buffer_m: f64,
    /// Viscosity D1PEKS, Pa s.
    pub viscosity_pa_s: f64,
    /// Settings without dimension, in the order of [`Parameter::ALL`].
    pub values: [f64; 5],
}

impl Solution {
    /// A setting without dimension.
    #[must_use]
    pub fn value(&self, parameter: Parameter) -> f64 {
        self.values[parameter as usize]
    }

    /// Triangles times steps.
    #[must_use]
    pub fn triangle_steps(&self) -> f64 {
        self.triangles as f64 * self.steps as f64
    }
}

/// Errors beyond this many times the answer are those of an unstable run.
const ABSURD: f64 = 1e3;

/// Solves a problem.
///
/// # Errors
/// If its deck cannot be made.
pub fn solve(problem: &dyn Problem, settings: Settings) -> Result<Solution, BenchError> {
    let fault = |message: String| BenchError::Problem { problem: problem.name(), message };
    let refinement = settings.mesh.unwrap_or(1.0).round().max(1.0);
    let mut scenario = problem.scenario(refinement as usize);
    let answer = problem.answer();
    let height = Made::of(&answer, &scenario)?.mean_height();
    let material =
        problem.material(&mut scenario).ok_or_else(|| fault("there is no material".to_owned()))?;
    if let Some(ratio) = settings.penalty {
        let tangential = material.tangential_penalty_pa / material.penalty_pa;
        material.penalty_pa = ratio * material.young_pa;
        material.tangential_penalty_pa = tangential * material.penalty_pa;
    }
    let natural = 2.0 * height * (material.young_pa * material.density_kg_m3).sqrt();
    if let Some(ratio) = settings.viscosity {
        material.viscosity_pa_s = Some(ratio * natural);
    }
    let material = *material;
    if let Some(share) = settings.time_step {
        scenario.run.step_s = Some(share * Made::of(&answer, &scenario)?.bounds().together_s);
    }
    let buffer_m = settings.buffer.map(|ratio| ratio * height);
    scenario.run.contact_buffer_m = buffer_m;
    let made = Made::of(&answer, &scenario)?;
    let (step_s, end_s) = made.times();
    let steps = (end_s / step_s).ceil().clamp(1.0, 1e9) as u64;
    let (buffer_m, outcome) = match (&made, &answer) {
        (Made::Plane(made), Answer::Plane(problem)) => {
            let build = |deck: &Deck, database: &Database| {
                from_deck(deck, database, "problem", Profile::default())
            };
            let mut scene = scene(&made.deck, build).map_err(fault)?;
            problem.start(&mut scene);
            let buffer = scene.contact.as_ref().map_or(f64::NAN, |contact| contact.buffer);
            let mut simulation = Simulation::new(scene);
            simulation.prepare().map_err(|error| fault(error.to_string()))?;
            let run = Run { made: &**made, simulation, steps, done: 0 };
            (buffer, run.solved(|run| problem.error(run)))
        }
        (Made::Space(made), Answer::Space(problem)) => {
            let spatial_contact = problem.contact();
            let build = |deck: &Deck, database: &Database| {
                spatial_from_deck(deck, database, "problem", Profile::default(), spatial_contact)
            };
            let mut scene = scene(&made.deck, build).map_err(fault)?;
            problem.start(&mut scene);
            let buffer = scene.contact.as_ref().map_or(f64::NAN, |contact| contact.buffer);
            let options = SolverOptions { spatial_contact, ..SolverOptions::default() };
            let mut simulation = SpatialSimulation::with_options(scene, options);
            simulation.prepare().map_err(|error| fault(error.to_string()))?;
            let run = Run { made: &**made, simulation, steps, done: 0 };
            (buffer, run.solved(|run| problem.error(run)))
        }
        _ => unreachable!("a problem's scenario is of its own kind"),
    };
    let viscosity_pa_s = material.viscosity(height);
    let values = [
        step_s / made.bounds().together_s,
        material.penalty_pa / material.young_pa,
        buffer_m / height,
        refinement,
        viscosity_pa_s / natural,
    ];
    Ok(Solution {
        error: outcome.error,
        seconds: outcome.seconds,
        steps: outcome.steps,
        triangles: outcome.bodies,
        detections: outcome.work.detections,
        couples: outcome.work.evaluated,
        step_s,
        penalty_pa: material.penalty_pa,
        buffer_m,
        viscosity_pa_s,
        values,
    })
}

/// What the generators made.
enum Made {
    Plane(Box<Generated>),
    Space(Box<SpatialGenerated>),
}

impl Made {
    fn of(answer: &Answer<'_>, scenario: &Scenario) -> Result<Self, BenchError> {
        Ok(match answer {
            Answer::Plane(_) => Self::Plane(Box::new(scenario.generate()?)),
            Answer::Space(_) => Self::Space(Box::new(scenario.generate_in_space()?)),
        })
    }

    fn bounds(&self) -> &TimeStepBounds {
        match self {
            Self::Plane(made) => &made.bounds,
            Self::Space(made) => &made.bounds,
        }
    }

    /// Time step and end, s.
    fn times(&self) -> (f64, f64) {
        match self {
            Self::Plane(made) => (made.step_s, made.end_s),
            Self::Space(made) => (made.step_s, made.end_s),
        }
    }

    /// Mean height of the triangles or tetrahedra, m, as the generators see it.
    fn mean_height(&self) -> f64 {
        let (heights, count): (f64, usize) = match self {
            Self::Plane(made) => {
                let mesh = &made.model.mesh;
                (mesh.triangles.iter().map(|t| mesh.height(t)).sum(), mesh.triangles.len())
            }
            Self::Space(made) => {
                let mesh = &made.model.mesh;
                (mesh.tetrahedra.iter().map(|t| mesh.height(t)).sum(), mesh.tetrahedra.len())
            }
        };
        heights / count.max(1) as f64
    }
}

/// The scene of a generated deck.
fn scene<const D: usize>(
    deck: &Deck,
    build: impl FnOnce(&Deck, &Database) -> BuildOutcome<D>,
) -> Result<Scene<D>, String> {
    let stages = deck.stages();
    let first = stages.first().ok_or("the deck has no stage")?;
    let mut database = Database::new(deck.dialect());
    for item in first.items.clone() {
        if let Some(error) = database.apply(deck, item).iter().find(|f| f.is_error()) {
            return Err(error.to_string());
        }
    }
    let built = build(deck, &database);
    built.scene.ok_or_else(|| {
        built.findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    })
}
