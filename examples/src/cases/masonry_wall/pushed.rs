//! A wall that was pushed, and its curve of force and displacement.

use crate::{Bench, CaseError, Finding, Run};
use ypsilon::{meshing::Scenario, session::Format};

/// Depth of the model by that of the test.
pub(super) const DEPTH: f64 = 5.0;

/// The mean shear strain at which the first branch is measured.
const FIRST: f64 = 0.5e-4;

/// A wall that was pushed.
pub(super) struct Pushed {
    pub scenario: Scenario,
    pub run: Run,
    /// Displacement of the upper beam \[m\], and horizontal force on it since the push began
    /// \[N\], 1 m deep.
    pub curve: Vec<[f64; 2]>,
}

impl Pushed {
    pub fn of(bench: &Bench, scenario: Scenario, name: &str) -> Result<Self, CaseError> {
        let run = bench.run(&scenario, name, &[Format::Vtu])?;
        let table = run.monitors()?;
        let (moved, force) = (table.find("upper beam ux")?, table.find("upper beam reaction-x")?);
        let still = table.rows.iter().take_while(|row| row[moved] <= 0.0).last();
        let before = still.map_or(0.0, |row| row[force]);
        let pushed = table.rows.iter().filter(|row| row[moved] > 0.0);
        let curve = pushed.map(|row| [row[moved], row[force] - before]).collect();
        Ok(Pushed { scenario, run, curve })
    }

    /// Where the first branch is measured \[m\].
    pub fn first(&self) -> f64 {
        let wall = self.scenario.wall.as_ref();
        wall.map_or(f64::NAN, |wall| FIRST * wall.brick_height_m * wall.courses as f64)
    }

    /// Stiffness of the first branch \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.secant(self.first())
    }

    /// Secant of the curve at a displacement \[N/m\].
    pub fn secant(&self, at: f64) -> f64 {
        self.force(at) / at
    }

    /// Largest force up to a displacement \[N\].
    pub fn largest(&self, up_to: f64) -> f64 {
        self.curve.iter().filter(|p| p[0] <= up_to).map(|p| p[1]).fold(0.0, f64::max)
    }

    /// Force at a displacement \[N\].
    pub fn force(&self, at: f64) -> f64 {
        self.curve.iter().find(|p| p[0] >= at).map_or(f64::NAN, |p| p[1])
    }

    /// Mean force from a displacement on \[N\].
    pub fn mean(&self, from: f64) -> f64 {
        let beyond = self.curve.iter().filter(|p| p[0] >= from);
        let (sum, n) = beyond.fold((0.0, 0.0), |(sum, n), p| (sum + p[1], n + 1.0));
        sum / n
    }

    /// The displacement from which on the force is a fifth below the first secant \[m\].
    pub fn yields(&self) -> f64 {
        let stiffness = self.stiffness();
        let beyond =
            self.curve.iter().find(|p| p[0] > self.first() && p[1] < 0.8 * stiffness * p[0]);
        beyond.map_or(f64::NAN, |p| p[0])
    }

    /// What the ground carries before the push: load and weight.
    pub fn vertical(&self, what: &str) -> Result<Finding, CaseError> {
        let table = self.run.monitors()?;
        let (time, column) = (table.find("time")?, table.find("lower beam reaction-y")?);
        let Some(wall) = &self.scenario.wall else {
            return Err(CaseError::missing("the scenario describes no wall".to_owned()));
        };
        let before = table.rows.iter().take_while(|row| row[time] < wall.shear_from_s).last();
        let found = before.map_or(f64::NAN, |row| row[column]);
        let width = wall.brick_length_m / 2.0 * wall.half_bricks_per_course as f64;
        let weight = 2400.0 * width * wall.brick_height_m * wall.courses as f64 * 9.81;
        let steel = 7600.0 * width * wall.beam_height_m * 9.81;
        let load = wall.vertical_stress_pa * width;
        let quantity = format!("reaction before the push, {what}");
        let expected = (load + weight + steel) / 1e3;
        Ok(Finding::value(&quantity, "kN", expected, found / 1e3, 0.02)
            .noted("Load and weight, the weight of the lower beam aside."))
    }

    pub fn first_branch(&self, what: &str) -> Finding {
        let (first, later) = (self.stiffness(), self.secant(2.0 * self.first()));
        let is_linear = (later / first - 1.0).abs() < 0.1;
        Finding::statement(
            &format!("first branch, {what}"),
            "linear",
            &format!(
                "{:.0} kN/mm up to {:.3} mm, {:.0} kN/mm up to {:.3} mm (0.2 m deep)",
                first / DEPTH / 1e6,
                1e3 * self.first(),
                later / DEPTH / 1e6,
                2e3 * self.first()
            ),
            is_linear,
        )
        .noted(if is_linear { "" } else { BENDS })
    }
}

/// Why the first branch of bonded bricks is not linear.
const BENDS: &str = "\
The law of a joint is a parabola up to its strength, so that the stiffness of bonded bricks falls from the start; \
and the joints at the corners that rise soften early.";
