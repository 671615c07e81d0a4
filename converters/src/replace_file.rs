//! Files that appear complete or not at all.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use tempfile::{Builder, NamedTempFile};

/// Writes `path` through a temporary file in the same folder, renamed when `write` has
/// succeeded. Whatever had the name before stays until then.
pub(crate) fn replace_file(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut NamedTempFile>) -> io::Result<()>,
) -> io::Result<()> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = Builder::new();
    builder.prefix(".ypsilon-").suffix(".part");
    // Temporary files are private by default; results are not. The umask still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let mut file = builder.tempfile_in(folder)?;
    let mut output = BufWriter::with_capacity(1 << 16, &mut file);
    write(&mut output)?;
    output.flush()?;
    drop(output);
    file.persist(path).map_err(|failed| failed.error)?;
    Ok(())
}
