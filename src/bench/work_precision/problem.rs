//! Problems with answers, and how they are solved.

use super::{
    recommendations::Purpose,
    settings::{Parameter, Settings},
};
use crate::{
    bench::BenchError,
    meshing::{Generated, Material, Scenario},
    scene::{Profile, Scene, from_deck},
    simulation::Simulation,
};
use std::time::Instant;
use yformat::database::Database;

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

    /// Changes what a scenario cannot say.
    fn start(&self, _scene: &mut Scene) {}

    /// Steps through the problem and gives its error, by the answer.
    fn error(&self, run: &mut Run<'_>) -> f64;
}

/// A problem that is being solved.
#[derive(Debug)]
pub struct Run<'a> {
    /// What the generator made.
    pub made: &'a Generated,
    /// The simulation, before its first step.
    pub simulation: Simulation,
    /// Steps to the end of the problem.
    pub steps: u64,
    /// Steps done.
    pub done: u64,
}

impl Run<'_> {
    /// Does a step. `false` at the end, or when nothing is finite any more.
    pub fn step(&mut self) -> bool {
        let is_over = self.done >= self.steps
            || (self.done.is_multiple_of(64) && !self.simulation.sum_kinetic_energy().is_finite());
        if is_over {
            return false;
        }
        self.simulation.evaluate_forces();
        self.simulation.advance();
        self.done += 1;
        true
    }

    /// Does all steps.
    pub fn finish(&mut self) {
        while self.step() {}
    }

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
    /// Triangles.
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
    let height = mean_height(&scenario.generate()?);
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
        scenario.run.step_s = Some(share * scenario.generate()?.bounds.together_s);
    }
    let buffer_m = settings.buffer.map(|ratio| ratio * height);
    scenario.run.contact_buffer_m = buffer_m;
    let made = scenario.generate()?;
    let mut scene = scene(&made).map_err(fault)?;
    problem.start(&mut scene);
    let buffer_m = scene.contact.as_ref().map_or(f64::NAN, |contact| contact.buffer);
    let mut simulation = Simulation::new(scene);
    simulation.prepare().map_err(|error| fault(error.to_string()))?;
    let triangles = simulation.triangles().count();
    let steps = (made.end_s / made.step_s).ceil().clamp(1.0, 1e9) as u64;
    let mut run = Run { made: &made, simulation, steps, done: 0 };
    let started = Instant::now();
    let error = problem.error(&mut run);
    let seconds = started.elapsed().as_secs_f64();
    let is_sound = error.is_finite() && error < ABSURD && run.done == steps;
    let work = run.simulation.couple_work().unwrap_or_default();
    let viscosity_pa_s = material.viscosity(height);
    let values = [
        made.step_s / made.bounds.together_s,
        material.penalty_pa / material.young_pa,
        buffer_m / height,
        refinement,
        viscosity_pa_s / natural,
    ];
    Ok(Solution {
        error: if is_sound { error } else { f64::NAN },
        seconds,
        steps,
        triangles,
        detections: work.detections,
        couples: work.evaluated,
        step_s: made.step_s,
        penalty_pa: material.penalty_pa,
        buffer_m,
        viscosity_pa_s,
        values,
    })
}

/// Mean height of the triangles, m, as the generators see it.
fn mean_height(made: &Generated) -> f64 {
    let mesh = &made.model.mesh;
    let heights: f64 = mesh.triangles.iter().map(|t| mesh.height(t)).sum();
    heights / mesh.triangles.len().max(1) as f64
}

/// The scene of a generated deck.
fn scene(made: &Generated) -> Result<Scene, String> {
    let deck = &made.deck;
    let stages = deck.stages();
    let first = stages.first().ok_or("the deck has no stage")?;
    let mut database = Database::new(deck.dialect());
    for item in first.items.clone() {
        if let Some(error) = database.apply(deck, item).iter().find(|f| f.is_error()) {
            return Err(error.to_string());
        }
    }
    let built = from_deck(deck, &database, "problem", Profile::default());
    built.scene.ok_or_else(|| {
        built.findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    })
}
