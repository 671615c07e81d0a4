//! All times of a run.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use yformat::d3plot::FamilyReader;
use ypsilon_converters::detect::{FileKind, detect};
use ypsilon_converters::vtk::{read_pvd, read_vtu};

use super::d3plot::{FrameError, frame};
use super::frame::Frame;
use super::vtk::{bodies, dimension, joints, time};
use crate::error::{PostError, at};
use crate::point::in_words;

/// Results of a run on disk: frames are read one at a time.
pub struct Results {
    path: PathBuf,
    times: Vec<f64>,
    source: Source,
    /// Number of dimensions, where it has been looked up.
    dimension: Option<usize>,
}

enum Source {
    Vtu(Vec<VtuFiles>),
    D3plot(Box<FamilyReader>),
}

/// The files of one time.
struct VtuFiles {
    bodies: PathBuf,
    joints: Option<PathBuf>,
}

/// Which time is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FrameChoice {
    /// The last one.
    Last,
    /// The n-th, from 0.
    Index(usize),
    /// The one nearest to a time, s.
    Time(f64),
}

impl std::str::FromStr for FrameChoice {
    type Err = PostError;

    /// `last`, `#3` (the fourth), or a time in s.
    fn from_str(words: &str) -> Result<Self, PostError> {
        let expected = "expected a time in s, `#` and a number from 0, or `last`";
        let wrong = || PostError::words("the time", words, expected);
        match words.trim().strip_prefix('#') {
            _ if words.trim() == "last" => Ok(Self::Last),
            Some(index) => index.parse().map(Self::Index).map_err(|_| wrong()),
            None => {
                let time = words.trim().parse().ok().filter(|t: &f64| t.is_finite());
                time.map(Self::Time).ok_or_else(wrong)
            }
        }
    }
}

impl Results {
    /// Opens a `.pvd` collection, a single `.vtu` file (the file of its joints is found beside
    /// it), the first file of a d3plot family, or a folder with one collection in it.
    ///
    /// # Errors
    /// If `path` is none of these, cannot be read, or shows no time at all.
    pub fn open(path: &Path) -> Result<Self, PostError> {
        if path.is_dir() {
            return Self::open(&only_collection(path)?);
        }
        let mut head = Vec::new();
        File::open(path).and_then(|f| f.take(4096).read_to_end(&mut head)).map_err(at(path))?;
        let no_results =
            |message: String| PostError::NoResults { path: path.to_path_buf(), message };
        let results = if detect(&head) == FileKind::D3plot {
            let reader = FamilyReader::open(path)
                .map_err(|source| PostError::D3plot { path: path.to_path_buf(), source })?;
            let times = reader.times().iter().map(|&t| f64::from(t)).collect();
            let dimension = Some(if reader.geometry().solids.is_empty() { 2 } else { 3 });
            let source = Source::D3plot(Box::new(reader));
            Self { path: path.to_path_buf(), times, source, dimension }
        } else if holds(&head, "type=\"Collection\"") {
            Self::collection(path)?
        } else if holds(&head, "type=\"UnstructuredGrid\"") {
            let grid = read_vtu(path)?;
            let files = VtuFiles { bodies: path.to_path_buf(), joints: joints_beside(path) };
            let (times, source) = (vec![time(&grid)], Source::Vtu(vec![files]));
            Self { path: path.to_path_buf(), times, source, dimension: Some(dimension(&grid)) }
        } else {
            return Err(no_results(
                "expected a .pvd collection, a .vtu file or a d3plot family; \
                 `ypsilon convert` makes collections of .ym snapshots"
                    .to_owned(),
            ));
        };
        if results.times.is_empty() {
            return Err(no_results("there are no states in it".to_owned()));
        }
        Ok(results)
    }

    fn collection(path: &Path) -> Result<Self, PostError> {
        let folder = path.parent().unwrap_or(Path::new(""));
        let (mut times, mut files) = (Vec::new(), Vec::<VtuFiles>::new());
        for entry in read_pvd(path)? {
            let file = folder.join(&entry.file);
            match entry.part {
                0 => {
                    times.push(entry.time);
                    files.push(VtuFiles { bodies: file, joints: None });
                }
                1 if entry.name == "joints" && times.last() == Some(&entry.time) => {
                    if let Some(last) = files.last_mut() {
                        last.joints = Some(file);
                    }
                }
                _ => {}
            }
        }
        Ok(Self { path: path.to_path_buf(), times, source: Source::Vtu(files), dimension: None })
    }

    /// The file that was opened.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// All times, s, in the order of the run.
    #[must_use]
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// How many frames there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.times.len()
    }

    /// Whether there are no frames; an opened series always has one.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.times.is_empty()
    }

    /// The frame that is meant, by number.
    ///
    /// # Errors
    /// If there are not so many.
    pub fn index_of(&self, choice: FrameChoice) -> Result<usize, PostError> {
        let last = self.times.len() - 1;
        match choice {
            FrameChoice::Last => Ok(last),
            FrameChoice::Index(index) if index <= last => Ok(index),
            FrameChoice::Index(index) => Err(PostError::Nothing(format!(
                "{} has no state #{index}; states are #0 to #{last}",
                self.path.display()
            ))),
            FrameChoice::Time(time) => {
                let distance = |i: usize| self.times.get(i).map_or(f64::NAN, |t| (t - time).abs());
                let nearest = (0..=last).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
                Ok(nearest.unwrap_or(last))
            }
        }
    }

    /// Number of dimensions: 2 for triangles in the plane, 3 for tetrahedra in space.
    ///
    /// # Errors
    /// If the file of the first time cannot be read.
    pub fn dimension(&mut self) -> Result<usize, PostError> {
        if let Some(dimension) = self.dimension {
            return Ok(dimension);
        }
        let first = match &self.source {
            Source::Vtu(files) => files.first(),
            Source::D3plot(_) => None,
        };
        let found = match first {
            Some(files) => dimension(&read_vtu(&files.bodies)?),
            None => 2,
        };
        Ok(*self.dimension.insert(found))
    }

    /// Reads frame number `index` of plane results.
    ///
    /// # Errors
    /// If its files cannot be read or hold bodies in space.
    pub fn frame(&mut self, index: usize) -> Result<Frame, PostError> {
        self.frame_in(index)
    }

    /// Reads frame number `index` of results in `D` dimensions, whose elements have `C` corners:
    /// 2 and 3, or 3 and 4.
    ///
    /// # Errors
    /// If its files cannot be read or hold bodies of other dimensions.
    pub fn frame_in<const D: usize, const C: usize>(
        &mut self,
        index: usize,
    ) -> Result<Frame<D, C>, PostError> {
        let no_state = || PostError::Nothing(format!("there is no state #{index}"));
        let time = *self.times.get(index).ok_or_else(no_state)?;
        let wrong = |path: &Path, message: String| PostError::NoResults {
            path: path.to_path_buf(),
            message,
        };
        let fits = |path: &Path, found: usize| {
            let instead = if D == 2 { "; `ypsilon extract` makes tables of them" } else { "" };
            let [found_in, expected] = [found, D].map(in_words);
            let message = format!("bodies {found_in}, expected bodies {expected}{instead}");
            if found == D { Ok(()) } else { Err(wrong(path, message)) }
        };
        match &mut self.source {
            Source::Vtu(files) => {
                let files = files.get(index).ok_or_else(no_state)?;
                let grid = read_vtu(&files.bodies)?;
                if !grid.cells.is_empty() {
                    fits(&files.bodies, dimension(&grid))?;
                }
                let mut frame = bodies(&grid).map_err(|m| wrong(&files.bodies, m))?;
                frame.time = time;
                if let Some(path) = &files.joints {
                    frame.joints = joints(&read_vtu(path)?);
                }
                Ok(frame)
            }
            Source::D3plot(reader) => {
                fits(&self.path, if reader.geometry().solids.is_empty() { 2 } else { 3 })?;
                frame(reader, index).map_err(|error| match error {
                    FrameError::Read(source) => {
                        PostError::D3plot { path: self.path.clone(), source }
                    }
                    FrameError::Form(message) => wrong(&self.path, message.to_owned()),
                    FrameError::Damaged(message) => wrong(&self.path, message),
                })
            }
        }
    }
}

/// Calls a function that is generic over the dimension and the number of corners with those of
/// some [`Results`].
macro_rules! by_dimension {
    ($results:expr, $function:ident($($argument:expr),* $(,)?)) => {
        match $results.dimension()? {
            2 => $function::<2, 3>($results, $($argument),*),
            _ => $function::<3, 4>($results, $($argument),*),
        }
    };
}
pub(crate) use by_dimension;

fn holds(head: &[u8], words: &str) -> bool {
    head.windows(words.len()).any(|window| window == words.as_bytes())
}

/// `wall_joints_0000200.vtu` beside `wall_0000200.vtu`.
fn joints_beside(path: &Path) -> Option<PathBuf> {
    let name = path.file_name()?.to_str()?;
    let (front, back) = name.rsplit_once('_')?;
    let joints = path.with_file_name(format!("{front}_joints_{back}"));
    joints.is_file().then_some(joints)
}

fn only_collection(folder: &Path) -> Result<PathBuf, PostError> {
    let entries = std::fs::read_dir(folder).map_err(at(folder))?;
    let mut found: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|e| e == "pvd"))
        .collect();
    found.sort();
    let message = match found.as_slice() {
        [only] => return Ok(only.clone()),
        [] => "there is no .pvd collection in this folder".to_owned(),
        several => {
            let names = several.iter().filter_map(|p| p.file_name()?.to_str());
            let names: Vec<&str> = names.collect();
            format!("there are several collections here; name one of {}", names.join(", "))
        }
    };
    Err(PostError::NoResults { path: folder.to_path_buf(), message })
}
