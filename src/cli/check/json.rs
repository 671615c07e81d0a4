//! Findings and figures for scripts.

use super::findings_of;
use crate::{
    assessment::Assessment,
    session::{DeckFault, LoadedDeck, SceneSize},
};
use serde_json::{Value, json};
use std::path::Path;
use yformat::diagnostic::Diagnostic;

/// A deck that can be run.
pub(super) fn report(deck: &Path, loaded: &LoadedDeck, assessment: Option<&Assessment>) -> Value {
    let scene = loaded.simulation.as_ref().map(|simulation| {
        let size = SceneSize::of(simulation);
        json!({
            "stages": loaded.stages.len(),
            "nodes": size.nodes,
            "triangles": size.triangles,
            "tetrahedra": size.tetrahedra,
            "joints": size.joints,
        })
    });
    let assessed = assessment.iter().flat_map(|assessment| &assessment.findings);
    let findings = loaded.findings.iter().chain(assessed);
    json!({
        "deck": deck.display().to_string(),
        "runs": loaded.simulation.is_some(),
        "findings": findings.map(finding).collect::<Vec<_>>(),
        "scene": scene,
        "assessment": assessment,
    })
}

/// A deck that cannot.
pub(super) fn fault(deck: &Path, fault: &DeckFault) -> Value {
    let mut findings: Vec<Value> = findings_of(fault).iter().map(finding).collect();
    if let DeckFault::Io { .. } = fault {
        findings.push(json!({
            "severity": "error", "code": "deck::unreadable", "message": fault.to_string(),
        }));
    }
    json!({ "deck": deck.display().to_string(), "runs": false, "findings": findings })
}

fn finding(finding: &Diagnostic) -> Value {
    let notes = &finding.notes;
    json!({
        "severity": finding.severity.to_string(),
        "code": finding.code,
        "message": finding.message,
        "place": notes.location.as_ref().map(ToString::to_string),
        "found": notes.label,
        "expected": notes.expected,
        "help": notes.help,
    })
}
