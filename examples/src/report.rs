//! READMEs of cases and the report of all of them.

use crate::{
    Case, CaseError, Expected, Finding, Group, Obtained, Tolerance,
    case::examples,
    record::{Record, write},
};
use std::fmt::Write as _;

/// Where the written part of a README begins and ends.
const MARKS: [&str; 2] = ["<!-- results -->", "<!-- end of results -->"];

/// Rewrites the part of a case's README between its marks; makes the file if there is none.
///
/// # Errors
/// If it cannot be read or written, or lacks its marks.
pub fn readme(case: &Case, record: &Record) -> Result<(), CaseError> {
    let path = case.folder().join("README.md");
    let old = match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => {
            format!("# {}\n\n{}\n{}\n", case.title, MARKS[0], MARKS[1])
        }
        Err(source) => return Err(CaseError::Io { path, source }),
    };
    let parts = old.split_once(MARKS[0]).and_then(|(before, rest)| {
        let (_, after) = rest.split_once(MARKS[1])?;
        Some((before, after))
    });
    let Some((before, after)) = parts else {
        let message = format!("{} lacks {} and {}", path.display(), MARKS[0], MARKS[1]);
        return Err(CaseError::missing(message));
    };
    let text = format!("{before}{}\n{}{}{after}", MARKS[0], case_text(case, record)?, MARKS[1]);
    write(&path, &text)
}

/// The scenario files of a case.
fn scenarios(case: &Case) -> Result<Vec<String>, CaseError> {
    let path = case.folder();
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&path).map_err(CaseError::at(&path))? {
        let name = entry.map_err(CaseError::at(&path))?.file_name();
        let name = name.to_string_lossy();
        if name.ends_with(".toml") {
            names.push(name.into_owned());
        }
    }
    names.sort();
    Ok(names)
}

fn case_text(case: &Case, record: &Record) -> Result<String, CaseError> {
    let mut text = format!("{}\n\nSource: {}\n\n", case.about.trim(), case.source);
    let _ = writeln!(
        text,
        "```sh\ncargo run --release -p ypsilon-examples -- report --only {}\n```\n",
        case.name
    );
    let scenarios = scenarios(case)?;
    let count = scenarios.len();
    if let Some(first) = scenarios.first() {
        let path = format!("examples/{}/{}", case.group.folder(), case.name);
        let others = match count {
            1 => "A single run, with results for ParaView and `ypsilon plot`:".to_owned(),
            _ => format!("Single runs, of one of {}:", scenarios.join(", ")),
        };
        let _ = writeln!(
            text,
            "{others}\n\n```sh\nypsilon run {path}/{first} --out results --formats vtu\n```\n"
        );
    }
    text.push_str("| quantity | expected | obtained | difference | tolerance | |\n");
    text.push_str("|---|---|---|---|---|---|\n");
    for finding in &record.outcome.findings {
        let [expected, obtained, difference] = cells(finding);
        let _ = writeln!(
            text,
            "| {} | {expected} | {obtained} | {difference} | {} | {} |",
            finding.quantity,
            tolerance(finding),
            verdict(finding)
        );
    }
    let _ = writeln!(
        text,
        "\nRun time {}, {} triangle-steps (Ypsilon {}).",
        seconds(record.seconds),
        short(record.triangle_steps as f64),
        record.version
    );
    let mut notes: Vec<&str> = Vec::new();
    for finding in &record.outcome.findings {
        if !finding.note.is_empty() && !notes.contains(&finding.note.as_str()) {
            notes.push(&finding.note);
            let _ = writeln!(text, "\n{}: {}", finding.quantity, finding.note);
        }
    }
    for figure in &record.outcome.pictures {
        let _ = writeln!(text, "\n![{0}]({1})\n\n*{0}*", figure.caption, figure.file);
    }
    text.push('\n');
    Ok(text)
}

/// Rewrites the report of all cases.
///
/// # Errors
/// If results cannot be read or the report cannot be written.
pub fn all(cases: &[&Case]) -> Result<(), CaseError> {
    let mut text = String::from(
        "# Report of all cases\n\nMade by `cargo run --release -p ypsilon-examples -- report`; \
         do not edit. Differences are obtained minus\nexpected. Each case's folder has its data, \
         its pictures and how to run it alone.\n",
    );
    let mut counts = [0; 3];
    let mut groups = String::new();
    for group in Group::ALL {
        let _ = writeln!(groups, "\n## {}\n", group.title());
        groups.push_str("| case | quantity | expected | obtained | difference | | run time |\n");
        groups.push_str("|---|---|---|---|---|---|---|\n");
        for case in cases.iter().filter(|case| case.group == group) {
            rows(case, Record::read(case)?.as_ref(), &mut groups, &mut counts);
        }
        for name in without_case(group, cases)? {
            let folder = format!("{}/{name}", group.folder());
            let _ = writeln!(groups, "| [{name}]({folder}) | not evaluated yet | | | | | |");
        }
    }
    let [agree, differ, told] = counts;
    let _ = writeln!(
        text,
        "\n{} cases: {agree} findings agree, {differ} do not, {told} are told without judgement.",
        cases.len()
    );
    text.push_str(&groups);
    write(&examples().join("REPORT.md"), &text)
}

/// Folders of a group that no case evaluates.
fn without_case(group: Group, cases: &[&Case]) -> Result<Vec<String>, CaseError> {
    let path = examples().join(group.folder());
    if !path.is_dir() {
        return Ok(Vec::new());
    }
    let mut names = Vec::new();
    for entry in std::fs::read_dir(&path).map_err(CaseError::at(&path))? {
        let entry = entry.map_err(CaseError::at(&path))?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let known = cases.iter().any(|case| case.group == group && case.name == name);
        if entry.path().is_dir() && !known {
            names.push(name);
        }
    }
    names.sort();
    Ok(names)
}

fn rows(case: &Case, record: Option<&Record>, text: &mut String, counts: &mut [usize; 3]) {
    let link = format!("[{}]({}/{}/README.md)", case.title, case.group.folder(), case.name);
    let Some(record) = record else {
        let _ = writeln!(text, "| {link} | no results: this case has not been run | | | | | |");
        return;
    };
    for (index, finding) in record.outcome.findings.iter().enumerate() {
        let [expected, obtained, difference] = cells(finding);
        let (link, time) = match index {
            0 => (link.as_str(), seconds(record.seconds)),
            _ => ("", String::new()),
        };
        let kind = if !finding.is_judged() { 2 } else { usize::from(!finding.agrees()) };
        counts[kind] += 1;
        let mut said = verdict(finding);
        if !finding.agrees() {
            let why = if finding.note.is_empty() { "no reason is known" } else { &finding.note };
            // a row of a table is one line
            let why = why.replace('\n', " ");
            let _ = write!(said, ": {why}");
        }
        let _ = writeln!(
            text,
            "| {link} | {} | {expected} | {obtained} | {difference} | {said} | {time} |",
            finding.quantity
        );
    }
    if record.outcome.findings.is_empty() {
        let _ = writeln!(text, "| {link} | no findings | | | | | |");
    }
}

fn cells(finding: &Finding) -> [String; 3] {
    let unit = |number: String| match finding.unit.as_str() {
        "" => number,
        unit => format!("{number} {unit}"),
    };
    let expected = match &finding.expected {
        Expected::Value(value) => unit(short(*value)),
        Expected::Range([low, high]) => unit(format!("{} to {}", short(*low), short(*high))),
        Expected::Text(text) => text.clone(),
    };
    let obtained = match &finding.obtained {
        Obtained::Value(value) => unit(short(*value)),
        Obtained::Text { text, .. } => text.clone(),
    };
    let difference = match (&finding.expected, finding.difference()) {
        (Expected::Value(expected), Some(difference)) if *expected != 0.0 => {
            let percent = 100.0 * difference / expected.abs();
            format!("{} %", if percent.abs() < 1e-12 { "0".to_owned() } else { digits(percent, 2) })
        }
        (Expected::Value(_), Some(difference)) => unit(digits(difference, 2)),
        (Expected::Range(_), Some(difference)) if difference != 0.0 => unit(digits(difference, 2)),
        _ => String::new(),
    };
    [expected, obtained, difference]
}

fn tolerance(finding: &Finding) -> String {
    match (&finding.expected, &finding.tolerance) {
        (_, Tolerance::NotJudged(reason)) => format!("none: {reason}"),
        (Expected::Value(_), Tolerance::Relative(part)) => format!("{} %", short(100.0 * part)),
        (Expected::Value(_), Tolerance::Absolute(by)) => {
            format!("{} {}", short(*by), finding.unit).trim_end().to_owned()
        }
        _ => String::new(),
    }
}

fn verdict(finding: &Finding) -> String {
    match (finding.is_judged(), finding.agrees()) {
        (false, _) => "told".to_owned(),
        (true, true) => "agrees".to_owned(),
        (true, false) => "**differs**".to_owned(),
    }
}

/// A number with five significant digits at most.
#[must_use]
pub fn short(value: f64) -> String {
    digits(value, 5)
}

/// A run time: more digits would differ from run to run.
fn seconds(value: f64) -> String {
    if value < 0.1 { "below 0.1 s".to_owned() } else { format!("{} s", digits(value, 2)) }
}

fn digits(value: f64, count: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".to_owned() } else { value.to_string() };
    }
    let rounded: f64 = format!("{value:.*e}", count - 1).parse().unwrap_or(value);
    match rounded.abs() {
        size if (1e-3..1e6).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!(short(0.1), "0.1");
        assert_eq!(short(1.0 / 3.0), "0.33333");
        assert_eq!(short(-4.399e12), "-4.399e12");
        assert_eq!(short(1e-9), "1e-9");
        assert_eq!(short(12345.678), "12346");
    }

    #[test]
    fn differences_are_percent_where_that_has_sense() {
        let finding = Finding::value("length", "m", 2.0, 2.01, 0.01);
        assert_eq!(cells(&finding), ["2 m", "2.01 m", "0.5 %"]);
        let zero = Finding::within("stress", "Pa", 0.0, 3e-7, 1e-6);
        assert_eq!(cells(&zero)[2], "3e-7 Pa");
    }
}
