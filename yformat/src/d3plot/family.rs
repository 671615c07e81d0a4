//! How a family is spread over files.

use std::path::{Path, PathBuf};

/// The word that ends every file of a family but the last.
pub const END_OF_FILE_MARKER: f32 = -999_999.0;

/// How many states Y puts in one file of a family.
///
/// `nodes` and `elements` are `NNOPO` and `NELEM` at the first output, joints and the elements
/// that are not written included. The rule underestimates the size of a state.
///
/// ```
/// assert_eq!(yformat::d3plot::states_per_file(441, 800), 145);
/// ```
pub fn states_per_file(nodes: usize, elements: usize) -> u64 {
    let bytes = (nodes as u128 * 6 + elements as u128 * 8) * 4;
    let blocks = bytes / 512 + 1;
    // 10240 divided by something of at least 1 fits.
    (10_240 / blocks) as u64 + 1
}

/// The path of file `index` of a family: the name itself, then `name01`, `name02`, ...,
/// `name99`, `name100`, ...
///
/// ```
/// use std::path::Path;
/// use yformat::d3plot::member_path;
/// assert_eq!(member_path(Path::new("out/wall"), 0), Path::new("out/wall"));
/// assert_eq!(member_path(Path::new("out/wall"), 7), Path::new("out/wall07"));
/// assert_eq!(member_path(Path::new("out/wall"), 100), Path::new("out/wall100"));
/// ```
pub fn member_path(first: &Path, index: u32) -> PathBuf {
    if index == 0 {
        return first.to_path_buf();
    }
    let mut name = first.as_os_str().to_os_string();
    name.push(format!("{index:02}"));
    PathBuf::from(name)
}
