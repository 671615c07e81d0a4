//! Files beside the repository that may be absent.

use std::path::{Path, PathBuf};

/// Where they are: `YPSILON_SHARED`, or `shared` beside the repository.
pub fn folder() -> PathBuf {
    match std::env::var_os("YPSILON_SHARED") {
        Some(folder) => PathBuf::from(folder),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared"),
    }
}

/// Files of the classic dialect there, in the order of their paths. If there are none, a line
/// says so and the caller's loop does nothing.
pub fn with_ending(ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for part in ["reference/classic", "thirdparty/acse", "thirdparty/reference/classic"] {
        collect(&folder().join(part), ending, &mut found);
    }
    found.sort();
    if found.is_empty() {
        println!("skipped: no files *{ending} under {}", folder().display());
    }
    found
}

fn collect(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            collect(&path, ending, found);
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
}
