use super::Reader;
use crate::scene::Control;
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read(reader: &mut Reader<'_>) -> Control {
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
    if sideways != 0.0 {
        reader.report(
            Diagnostic::warning(
                "scene::no-effect",
                format!("gravity along x ({sideways}) has no effect in 2D"),
            )
            .at(reader.place("YDC/DCGRAX"))
            .help("2D scenes have gravity along y only (DCGRAY); turn the model to tilt it"),
        );
    }
    let table = if reader.knows("YDC/ICSHTF") { "YDC/ICSHTF" } else { "YDC/ICOUTF" };
    let steps = |n: i64| u64::try_from(n).unwrap_or(0);
    Control {
        first_step: steps(first),
        end_step: steps(end),
        time_step,
        start_time: reader.real("YDC/DCTIME"),
        gravity: reader.real("YDC/DCGRAY"),
        output_interval: steps(reader.integer("YDC/ICOUTF")).max(1),
        table_interval: steps(reader.integer(table)).max(1),
    }
}

/// The split dialect has an interval of its own where the deck gives none; the others divide by
/// the deck's.
pub(super) fn check_use(reader: &mut Reader<'_>) {
    let interval = reader.integer("YDC/ICOUTF");
    if interval > 0 || reader.database.dialect() == Dialect::Split {
        return;
    }
    let message = if reader.is_given("YDC/ICOUTF") {
        format!("ICOUTF asks for results every {interval} steps")
    } else {
        "ICOUTF, the number of steps between results, is not given".to_owned()
    };
    reader.report(
        Diagnostic::error("scene::output-interval", message)
            .at(reader.place("YDC/ICOUTF"))
            .expected("1 or more: the original divides by it")
            .help("set /YD/YDC/ICOUTF to a number of steps; that of MCSTEP gives the first state only"),
    );
}
