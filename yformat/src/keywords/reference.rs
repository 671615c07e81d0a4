//! The keyword tables as text for people.

use std::fmt::Write;

use super::{Extent, Keyword, NumberKind, Role, tables};
use crate::dialect::Dialect;

/// Markdown tables of a dialect's keywords, one per database; only keywords whose path, unit or
/// meaning contains `filter`, whatever its case, if one is given.
///
/// ```
/// use yformat::{dialect::Dialect, keywords::reference};
/// let text = reference(Dialect::Split, Some("time step"));
/// assert!(text.contains("DCSTEC"));
/// ```
#[must_use]
pub fn reference(dialect: Dialect, filter: Option<&str>) -> String {
    let wanted = filter.unwrap_or_default().to_lowercase();
    let shows = |k: &&Keyword| {
        let text = format!("{} {} {}", k.path(), k.unit, k.meaning);
        text.to_lowercase().contains(&wanted)
    };
    let mut out = String::new();
    for table in tables(dialect) {
        let rows: String = table.keywords.iter().filter(shows).map(row).collect();
        if !rows.is_empty() {
            let _ = write!(
                out,
                "## {}\n\n| keyword | holds | default | unit | use | meaning |\n|---|---|---|---|---|---|\n{rows}\n",
                table.database
            );
        }
    }
    out
}

fn row(keyword: &Keyword) -> String {
    let kind = match keyword.number {
        NumberKind::Integer => "integer",
        NumberKind::Real => "real",
    };
    let extents: String = keyword
        .extents
        .iter()
        .map(|extent| match extent {
            Extent::Size(name) => format!("[{name}]"),
            Extent::Fixed(length) => format!("[{length}]"),
        })
        .collect();
    let default = if keyword.rank() == 0 {
        if keyword.default_known { keyword.default.to_string() } else { "?".to_owned() }
    } else if let Some(created) = keyword.created {
        format!("{} (others {})", created.value, keyword.fill)
    } else {
        format!("others {}", keyword.fill)
    };
    let role = match keyword.role {
        Role::Required => "required",
        Role::Used => "used",
        Role::Only3d => "3D only",
        Role::Recomputed => "recomputed",
        Role::NoEffect => "no effect",
        Role::Ignored => "ignored",
        Role::Refused(_) => "refused",
    };
    format!(
        "| {} | {kind}{extents} | {default} | {} | {role} | {} |\n",
        keyword.name, keyword.unit, keyword.meaning
    )
}
