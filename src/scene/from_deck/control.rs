use super::Reader;
use crate::scene::{Control, RefinedOutput};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read(reader: &mut Reader<'_>, dimension: usize) -> Control {
    let time_step = reader.real("YDC/DCSTEC");
    if time_step <= 0.0 {
        reader.report(
            Diagnostic::error("scene::time-step", format!("the time step is {time_step}"))
                .at(reader.place("YDC/DCSTEC"))
                .expected("a time step above 0, in seconds")
                .help("give the time step with /YD/YDC/DCSTEC"),
        );
    }
    let (first, end) = (reader.integer("YDC/NCSTEP"), reader.integer("YDC/MCSTEP"));
    if first < 0 {
        reader.report(
            Diagnostic::error("scene::step-count", format!("the first step is {first}"))
                .at(reader.place("YDC/NCSTEP"))
                .expected("0 or more"),
        );
    }
    if end <= first {
        reader.report(
            Diagnostic::warning(
                "scene::step-count",
                format!("there is no step to do: MCSTEP {end} is not above NCSTEP {first}"),
            )
            .at(reader.place("YDC/MCSTEP").or_else(|| reader.place("YDC/NCSTEP")))
            .help("set /YD/YDC/MCSTEP to the number of steps"),
        );
    }
    let sideways = reader.real("YDC/DCGRAX");
    if sideways != 0.0 && dimension == 2 {
        reader.report(
            Diagnostic::warning(
                "scene::no-effect",
                format!("gravity along x ({sideways}) has no effect in 2D"),
            )
            .at(reader.place("YDC/DCGRAX"))
            .help("2D scenes have gravity along y only (DCGRAY); turn the model to tilt it"),
        );
    }
    let interval = reader.integer("YDC/ICOUTF");
    if interval <= 0 && reader.database.dialect() != Dialect::Split {
        reader.report(
            Diagnostic::error(
                "scene::output-interval",
                format!("ICOUTF is {interval}: the original divides by it"),
            )
            .at(reader.place("YDC/ICOUTF"))
            .expected("the number of steps from one result state to the next, 1 or more")
            .help("give it with /YD/YDC/ICOUTF"),
        );
    }
    let table = if reader.knows("YDC/ICSHTF") { "YDC/ICSHTF" } else { "YDC/ICOUTF" };
    let steps = |n: i64| u64::try_from(n).unwrap_or(0);
    Control {
        first_step: steps(first),
        end_step: steps(end),
        time_step,
        start_time: reader.real("YDC/DCTIME"),
        gravity: ["YDC/DCGRAX", "YDC/DCGRAY", "YDC/DCGRAZ"].map(|name| reader.real(name)),
        output_interval: steps(reader.integer("YDC/ICOUTF")).max(1),
        refined_output: (reader.integer("YDC/ICOUTRF") > 0).then(|| RefinedOutput {
            interval: steps(reader.integer("YDC/ICOUTRF")),
            broken_joints: steps(reader.integer("YDC/ICOUTNF")),
        }),
        table_interval: steps(reader.integer(table)).max(1),
    }
}
