//! Reports as tables of a Markdown document.

use super::{BenchError, Growth, Report, Run, SceneReport, Spread};
use std::{fmt::Write as _, path::Path};
use yformat::part_file::PartFile;

/// Where the tables begin in a document.
pub const BEGIN: &str = "<!-- ypsilon bench: begin -->";
/// Where they end.
pub const END: &str = "<!-- ypsilon bench: end -->";

/// Puts tables between the markers of a document, or makes the document if there is none.
///
/// # Errors
/// If the document cannot be read or written, or has no markers: what people wrote is never
/// replaced.
pub fn write(report: &Report, path: &Path) -> Result<(), BenchError> {
    let tables = tables(report);
    let document = match std::fs::read_to_string(path) {
        Ok(old) => replaced(&old, &tables)
            .map_err(|message| BenchError::Markers { path: path.to_path_buf(), message })?,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            format!("# Benchmarks\n\n{BEGIN}\n{tables}{END}\n")
        }
        Err(error) => return Err(BenchError::io(path)(error)),
    };
    let write = || {
        let mut file = PartFile::create(path)?;
        std::io::Write::write_all(&mut file, document.as_bytes())?;
        file.complete()
    };
    write().map(drop).map_err(BenchError::io(path))
}

/// A document with what stands between its markers replaced.
///
/// # Errors
/// A message, if it does not hold both markers once, in order.
pub fn replaced(document: &str, tables: &str) -> Result<String, String> {
    let once = |marker: &str| match document.matches(marker).count() {
        1 => document.find(marker).ok_or_else(String::new),
        0 => Err(format!("the document has no line `{marker}`")),
        n => Err(format!("the document has `{marker}` {n} times")),
    };
    let (begin, end) = (once(BEGIN)? + BEGIN.len(), once(END)?);
    if begin > end {
        return Err(format!("`{END}` stands before `{BEGIN}`"));
    }
    Ok(format!("{}\n{tables}{}", &document[..begin], &document[end..]))
}

/// All tables of a report.
#[must_use]
pub fn tables(report: &Report) -> String {
    let mut text = String::new();
    let machine = &report.machine;
    let _ = writeln!(
        text,
        "\nVersion {}, {}, {} with {} cores ({}), medians of {} runs, smallest and largest in brackets.\n",
        report.version,
        report.date,
        machine.processor,
        machine.cores,
        machine.system,
        report.repeats
    );
    if !report.scenes.is_empty() {
        text.push_str(&speed(&report.scenes));
        text.push_str(&phases(&report.scenes));
    }
    for growth in &report.growth {
        text.push_str(&series(growth));
    }
    for note in &report.notes {
        let _ = writeln!(text, "{note}.\n");
    }
    text
}

/// Speed, memory and instructions of scenes.
fn speed(scenes: &[SceneReport]) -> String {
    let mut text = "Speed: million element-steps per second (triangles, or tetrahedra in 3D), of the step loop and of the whole process (start, reading, \
                    writing). Memory: the process's high-water mark.\n\n\
                    | scene | elements | joints | steps | threads | step loop | whole process | speed-up | memory, MB | bytes per element | instructions per element-step |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    for scene in scenes {
        for (index, run) in scene.runs.iter().enumerate() {
            let name = if index == 0 {
                format!("`{}`: {}", scene.name, scene.about)
            } else {
                String::new()
            };
            let size = |value: u64| if index == 0 { value.to_string() } else { String::new() };
            let counted = scene.instructions_per_triangle_step.filter(|_| index == 0);
            let _ = writeln!(
                text,
                "| {name} | {} | {} | {} | {} | {} | {} | {:.2} | {} | {} | {} |",
                size(scene.triangles as u64),
                size(scene.joints as u64),
                size(scene.steps),
                run.threads,
                millions(run.step_loop),
                millions(run.process),
                run.speed_up,
                run.peak_memory.map_or_else(dash, |bytes| format!("{:.1}", bytes as f64 / 1e6)),
                run.memory_per_triangle.map_or_else(dash, |bytes| format!("{bytes:.0}")),
                counted.map_or_else(
                    || if index == 0 { dash() } else { String::new() },
                    |n| format!("{n:.0}")
                ),
            );
        }
    }
    text.push('\n');
    text
}

/// Shares of the phases.
fn phases(scenes: &[SceneReport]) -> String {
    let mut text = "Nanoseconds per element-step in each phase, with its share of the step loop; couples evaluated and at rest \
                    per step.\n\n\
                    | scene | threads | elements | joints | detection | overlap | integration | output | couples | at rest | detections |\n\
                    |---|---|---|---|---|---|---|---|---|---|---|\n"
        .to_owned();
    for scene in scenes {
        for run in &scene.runs {
            let p = &run.phases;
            let parts = [
                p.triangles,
                p.joints,
                p.detection,
                p.overlap,
                p.integration,
                run.output_seconds(),
            ];
            let cells = parts.map(|seconds| phase(seconds, run, scene)).join(" | ");
            let _ = writeln!(
                text,
                "| `{}` | {} | {cells} | {:.0} | {:.0} | {} |",
                scene.name, run.threads, run.couples_per_step, run.rested_per_step, run.detections
            );
        }
    }
    text.push('\n');
    text
}

fn phase(seconds: f64, run: &Run, scene: &SceneReport) -> String {
    let work = scene.triangles as f64 * scene.steps as f64;
    let share = 100.0 * seconds / run.phases_of_seconds.max(1e-12);
    format!("{:.1} ({share:.0} %)", 1e9 * seconds / work.max(1.0))
}

fn series(growth: &Growth) -> String {
    let exponent = |p: Option<f64>| p.map_or_else(dash, |p| format!("{p:.3}"));
    let mut text = format!(
        "Growth of `{}`, threads: {}. Time of a step ∝ trianglesᵖ with p = {}, peak memory with p = {}.\n\n\
         | triangles | joints | steps | ns per triangle-step | memory, MB | bytes per triangle |\n\
         |---|---|---|---|---|---|\n",
        growth.name,
        growth.threads,
        exponent(growth.time_exponent),
        exponent(growth.memory_exponent)
    );
    for size in &growth.sizes {
        for run in &size.runs {
            let _ = writeln!(
                text,
                "| {} | {} | {} | {:.1} | {} | {} |",
                size.triangles,
                size.joints,
                size.steps,
                1e9 / run.step_loop.median,
                run.peak_memory.map_or_else(dash, |bytes| format!("{:.1}", bytes as f64 / 1e6)),
                run.memory_per_triangle.map_or_else(dash, |bytes| format!("{bytes:.0}")),
            );
        }
    }
    text.push('\n');
    text
}

fn millions(spread: Spread) -> String {
    let million = |x: f64| {
        let x = x / 1e6;
        if x < 9.95 { format!("{x:.2}") } else { format!("{x:.1}") }
    };
    format!("{} ({} to {})", million(spread.median), million(spread.min), million(spread.max))
}

fn dash() -> String {
    "–".to_owned()
}

#[cfg(test)]
mod tests {
    use super::{super::report::tests::example, *};

    #[test]
    fn tables_have_a_row_for_each_run() {
        let text = tables(&example());
        assert!(text.contains("| 5000 | 7400 | 1000 | 1 | 2.00 (1.80 to 2.20) | 1.90"), "{text}");
        assert!(
            text.contains("| 2 | 3.00 (2.80 to 3.20) | 2.90 (2.70 to 3.10) | 1.50 |"),
            "{text}"
        );
        assert!(text.contains("| `jointed` | 1 | 20.0 (10 %) | 40.0 (20 %) |"), "{text}");
        assert!(text.contains("p = 1.010, peak memory with p = –"), "{text}");
        // every row of a table has as many cells as its heading
        for table in text.split("\n\n").filter(|part| part.starts_with('|')) {
            let cells: Vec<usize> = table.lines().map(|row| row.matches('|').count()).collect();
            assert!(cells.iter().all(|&n| n == cells[0]) && cells.len() > 2, "{table}");
        }
    }

    #[test]
    fn only_what_stands_between_the_markers_is_replaced() {
        let old = format!("a\n{BEGIN}\nold\n{END}\nz\n");
        let new = format!("a\n{BEGIN}\nnew\n{END}\nz\n");
        assert_eq!(replaced(&old, "new\n").expect("a document"), new);
        assert_eq!(replaced(&new, "new\n").expect("a document"), new);
        for bad in ["", BEGIN, END, &format!("{END}{BEGIN}"), &format!("{BEGIN}{BEGIN}{END}")] {
            assert!(replaced(bad, "new\n").is_err(), "{bad}");
        }
    }

    #[test]
    fn documents_of_people_are_left_alone() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("notes.md");
        std::fs::write(&path, "mine\n").expect("a file");
        let error = write(&example(), &path).expect_err("no markers");
        assert!(error.to_string().contains("notes.md"), "{error}");
        assert_eq!(std::fs::read_to_string(&path).expect("the file"), "mine\n");
        let fresh = folder.path().join("fresh.md");
        write(&example(), &fresh).expect("a new document");
        write(&example(), &fresh).expect("the same again");
        let text = std::fs::read_to_string(&fresh).expect("the file");
        assert_eq!(text.matches(BEGIN).count(), 1);
        assert!(text.contains("`jointed`: a sheet"));
    }
}
