//! Figures for people.

use crate::{
    assessment::{Assessment, Resources},
    session::{LoadedDeck, SceneSize},
};
use std::{fmt::Write as _, path::Path};

/// What a deck holds and what a run of it will come to.
pub(super) fn report(deck: &Path, loaded: &LoadedDeck, assessment: Option<&Assessment>) -> String {
    let Some(simulation) = &loaded.simulation else {
        return format!("{}: nothing runs", deck.display());
    };
    let size = SceneSize::of(simulation);
    let mut text = format!(
        "{}: {}, {}, {}, {}: ready to run",
        deck.display(),
        counted(loaded.stages.len(), "stage"),
        counted(size.nodes, "node"),
        size.bodies_in_words(),
        counted(size.joints, "joint")
    );
    if let Some(assessment) = assessment {
        // writing to a string cannot fail
        let _ = write_assessment(&mut text, assessment);
        for finding in &assessment.findings {
            text.push_str("\n\n");
            text.push_str(finding.render(loaded.deck.sources()).trim_end_matches('\n'));
        }
    }
    text
}

fn write_assessment(text: &mut String, a: &Assessment) -> std::fmt::Result {
    match (a.critical_step_s, a.safety_factor) {
        (Some(critical), Some(factor)) => {
            write!(
                text,
                "\n  time step       {:e} s; critical {critical:.3e} s, safety factor {factor:.2}",
                a.time_step_s
            )?;
        }
        _ => write!(text, "\n  time step       {:e} s; nothing limits it", a.time_step_s)?,
    }
    if let Some(set_by) = &a.set_by {
        write!(text, "\n  set by          {set_by}")?;
        if let Some(place) = &a.place_m {
            let place: Vec<String> = place.iter().map(|x| format!("{x:.4}")).collect();
            write!(text, " at ({})", place.join(", "))?;
        }
    }
    let parts = [
        ("elements", a.of_elements_s),
        ("with joints", a.with_joints_s),
        ("with contacts", a.with_contacts_s),
        ("viscosity", a.of_viscosity_s),
        ("in an impact", a.critical_step_in_impact_s),
    ];
    let parts = parts.iter().filter_map(|(name, s)| s.map(|s| format!("{name} {s:.3e}")));
    let parts: Vec<String> = parts.collect();
    if !parts.is_empty() {
        write!(text, "\n  limits [s]      {}", parts.join(", "))?;
    }
    for set in &a.sets {
        write!(
            text,
            "\n  property set {:<2} {}, smallest {:.3e} m (element {}); D1PEKS {:e}, critical {:.2e}",
            set.set,
            counted(set.elements, "element"),
            set.smallest_height_m,
            set.smallest_element,
            set.viscosity_pa_s,
            set.critical_viscosity_pa_s
        )?;
        if set.safe_viscosity_pa_s.is_finite() {
            write!(text, ", each element alone stable to {:.2e} Pa s", set.safe_viscosity_pa_s)?;
        }
    }
    write_resources(text, &a.resources)
}

fn write_resources(text: &mut String, r: &Resources) -> std::fmt::Result {
    write!(text, "\n  run             {} steps", r.steps)?;
    if let Some(seconds) = r.seconds_on_one_core {
        write!(text, ", about {} on one core", duration(seconds))?;
    }
    if let Some(memory) = r.memory_bytes {
        write!(text, ", {} of memory", bytes(memory))?;
    }
    write!(text, "; {} states, about {} as d3plot and VTU", r.states, bytes(r.output_bytes))
}

/// `1 stage`, `2 stages`.
fn counted(count: usize, what: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {what}{plural}")
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 120.0 => format!("{s:.1} s"),
        s if s < 7200.0 => format!("{:.0} min", s / 60.0),
        s if s < 172_800.0 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.1} days", s / 86_400.0),
    }
}

fn bytes(count: u64) -> String {
    let mut value = count as f64;
    let units = ["bytes", "kB", "MB", "GB", "TB"];
    let mut unit = 0;
    while value >= 1000.0 && unit + 1 < units.len() {
        value /= 1000.0;
        unit += 1;
    }
    if unit == 0 { format!("{count} bytes") } else { format!("{value:.1} {}", units[unit]) }
}
