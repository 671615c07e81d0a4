//! What is wrong with an input file, where, and how to mend it.

use std::fmt;

use crate::source::{Location, SourceMap, Span};

mod render;

/// How bad it is.
///
/// ```
/// use yformat::diagnostic::Severity;
///
/// assert!(Severity::Error > Severity::Warning);
/// assert_eq!(Severity::Note.to_string(), "note");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing, nothing is wrong.
    Note,
    /// The file is read as the original programs read it, which may not be what its author meant.
    Warning,
    /// The original programs stop, crash or compute with garbage here.
    Error,
}

impl fmt::Display for Severity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Note => "note",
            Severity::Warning => "warning",
            Severity::Error => "error",
        })
    }
}

/// One finding about an input file.
///
/// `Display` gives one line (`wall.y:3:16: error[deck::unknown-word]: ...`), [`Diagnostic::render`]
/// the offending line with the words underlined.
///
/// ```
/// use yformat::diagnostic::Diagnostic;
/// use yformat::source::SourceMap;
///
/// let mut sources = SourceMap::new();
/// let deck = sources.add("wall.y", b"/YD/YDC/MCSTEP 2e4\n".to_vec());
/// let diagnostic = Diagnostic::error("deck::unknown-word", "an integer was expected")
///     .at(sources.span(deck, 15..18))
///     .label("this is a real")
///     .help("write 20000")
///     .located(&sources);
/// assert_eq!(diagnostic.to_string(), "wall.y:1:16: error[deck::unknown-word]: an integer was expected");
/// assert!(diagnostic.render(&sources).contains("help: write 20000"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// Stable name of the kind of finding, such as `deck::unknown-keyword`.
    pub code: &'static str,
    /// One sentence.
    pub message: String,
    /// The offending bytes.
    pub span: Option<Span>,
    /// What else there is to say. Boxed, because diagnostics travel in `Result`s.
    pub notes: Box<Notes>,
}

/// The optional parts of a [`Diagnostic`].
///
/// ```
/// use yformat::diagnostic::Diagnostic;
///
/// let diagnostic = Diagnostic::note("deck::example", "nothing is wrong").help("go on");
/// assert_eq!(diagnostic.notes.help.as_deref(), Some("go on"));
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Notes {
    /// Line and column of the span, once [`Diagnostic::located`] has looked them up.
    pub location: Option<Location>,
    /// What was found at the span.
    pub label: Option<String>,
    /// What should stand there.
    pub expected: Option<String>,
    /// How to mend the file.
    pub help: Option<String>,
}

impl Diagnostic {
    /// A finding of the given severity, without a place.
    #[must_use]
    pub fn new(severity: Severity, code: &'static str, message: impl Into<String>) -> Self {
        let message = printable(message.into());
        Diagnostic { severity, code, message, span: None, notes: Box::default() }
    }

    /// An error.
    #[must_use]
    pub fn error(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, code, message)
    }

    /// A warning.
    #[must_use]
    pub fn warning(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, code, message)
    }

    /// A note.
    #[must_use]
    pub fn note(code: &'static str, message: impl Into<String>) -> Self {
        Self::new(Severity::Note, code, message)
    }

    /// Points at the offending bytes; takes an `Option` too.
    #[must_use]
    pub fn at(mut self, span: impl Into<Option<Span>>) -> Self {
        self.span = span.into();
        self.notes.location = None;
        self
    }

    /// Says what was found there.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.notes.label = Some(printable(label.into()));
        self
    }

    /// Says what should stand there.
    #[must_use]
    pub fn expected(mut self, expected: impl Into<String>) -> Self {
        self.notes.expected = Some(printable(expected.into()));
        self
    }

    /// Says how to mend the file.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.notes.help = Some(printable(help.into()));
        self
    }

    /// Looks up line and column, for `Display`.
    #[must_use]
    pub fn located(mut self, sources: &SourceMap) -> Self {
        self.notes.location = self.span.map(|span| sources.location(span));
        self
    }

    /// Whether this is an error.
    #[must_use]
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }

    /// The finding with the offending line, the words underlined and the notes below, as plain
    /// text.
    #[must_use]
    pub fn render(&self, sources: &SourceMap) -> String {
        render::render(self, sources)
    }
}

/// Texts quote words of the file, whose control characters must not reach a terminal.
fn printable(text: String) -> String {
    if text.contains(char::is_control) { text.replace(char::is_control, "\u{FFFD}") } else { text }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(location) = &self.notes.location {
            write!(f, "{location}: ")?;
        }
        write!(f, "{}[{}]: {}", self.severity, self.code, self.message)
    }
}

impl std::error::Error for Diagnostic {}
