//! What is wrong with an input, and where.

use core::fmt;

/// A refused input: the path to the culprit, and what is wrong with it.
///
/// ```
/// let e = polhode::Error::new("inertia", "violates the triangle inequality").inside("bodies[3]");
/// assert_eq!(e.to_string(), "bodies[3].inertia: violates the triangle inequality");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    path: String,
    message: String,
}

impl Error {
    /// An error about the value at `path`, such as `mass` or `vertices[12]`.
    pub fn new(path: impl Into<String>, message: impl Into<String>) -> Self {
        Self { path: path.into(), message: message.into() }
    }
    /// The same error, seen from one level further out.
    pub fn inside(mut self, outer: impl fmt::Display) -> Self {
        self.path = match self.path.as_str() {
            "" => outer.to_string(),
            path if path.starts_with('[') => format!("{outer}{path}"),
            path => format!("{outer}.{path}"),
        };
        self
    }
    /// Where the culprit is: `bodies[3].inertia`.
    pub fn path(&self) -> &str {
        &self.path
    }
    /// What is wrong with it.
    pub fn message(&self) -> &str {
        &self.message
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.path.is_empty() { f.write_str(&self.message) } else { write!(f, "{}: {}", self.path, self.message) }
    }
}

impl core::error::Error for Error {}
