use super::{Exit, console::warn};
use crate::session::DeckFault;
use yformat::{
    diagnostic::{Diagnostic, Severity},
    source::SourceMap,
};

/// Prints findings with the lines they are about.
pub(super) fn print(findings: &[Diagnostic], sources: &SourceMap, least: Severity) {
    for finding in findings.iter().filter(|f| f.severity >= least) {
        warn(finding.render(sources).trim_end_matches('\n'));
        warn("");
    }
}

/// Prints why a deck cannot be run.
pub(super) fn print_fault(fault: &DeckFault, quiet: bool) -> Exit {
    match fault {
        DeckFault::Io { .. } => warn(&format!("error: {fault}")),
        DeckFault::Findings { sources, findings } => {
            print(findings, sources, if quiet { Severity::Error } else { Severity::Warning });
            let errors = findings.iter().filter(|f| f.is_error()).count();
            let plural = if errors == 1 { "error" } else { "errors" };
            warn(&format!("{errors} {plural}: the deck is not run, no file was written"));
        }
    }
    Exit::Input
}
