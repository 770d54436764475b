//! What is wrong with a file, where in it, and what would be right.

use std::fmt;
use std::ops::Range;

/// A scene file was refused. [`Display`](fmt::Display) prints every problem with the line it is on.
///
/// ```
/// use polhode_scene::SceneFile;
///
/// let error = SceneFile::parse("top.toml", "[[body]]\nname = \"top\"\nmas = 1\n").unwrap_err();
/// assert_eq!(error.problems()[0].line, 3);
/// assert!(error.to_string().contains("did you mean `mass`?"));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SceneError {
    file: String,
    problems: Vec<Problem>,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Which key: `body[2].shape[0].radius`; empty when it is about the whole file.
    pub path: String,
    /// Line, from 1; 0 when it is not about a place in the file.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// What is wrong.
    pub message: String,
    /// What would be right, where there is something to say.
    pub help: Option<String>,
    /// The line of the file, clipped, and how many characters of it are meant: `(text, from, length)`.
    excerpt: Option<(String, usize, usize)>,
}

/// The most problems that one error lists: enough to see a pattern, few enough to read.
pub(crate) const MOST_PROBLEMS: usize = 20;
/// The most characters of a line that an error prints.
const EXCERPT: usize = 110;

impl SceneError {
    pub(crate) fn new(file: &str, problems: Vec<Problem>) -> Self {
        Self { file: file.to_owned(), problems }
    }

    /// An error about a file as a whole, such as one that cannot be read.
    pub(crate) fn whole(file: &str, message: impl Into<String>) -> Self {
        let message = message.into();
        let problem = Problem { path: String::new(), line: 0, column: 0, message, help: None, excerpt: None };
        Self::new(file, vec![problem])
    }

    /// The file.
    pub fn file(&self) -> &str {
        &self.file
    }

    /// Everything that is wrong, in the order of the file; at most twenty problems.
    pub fn problems(&self) -> &[Problem] {
        &self.problems
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, problem) in self.problems.iter().enumerate() {
            if i > 0 {
                writeln!(f, "\n")?;
            }
            problem.write(f, &self.file)?;
        }
        Ok(())
    }
}

impl std::error::Error for SceneError {}

impl Problem {
    fn write(&self, f: &mut fmt::Formatter<'_>, file: &str) -> fmt::Result {
        write!(f, "error: {}", self.message)?;
        let gutter = self.line.to_string().len();
        if self.line == 0 {
            write!(f, "\n --> {file}")?;
        } else {
            write!(f, "\n{:gutter$}--> {file}:{}:{}", "", self.line, self.column)?;
        }
        if !self.path.is_empty() {
            write!(f, " ({})", self.path)?;
        }
        if let Some((text, from, length)) = &self.excerpt {
            let marks = "^".repeat(*length);
            write!(f, "\n{:gutter$} |\n{} | {text}\n{:gutter$} | {:from$}{marks}", "", self.line, "", "")?;
        }
        if let Some(help) = &self.help {
            write!(f, "\n{:gutter$} = help: {help}", "")?;
        }
        Ok(())
    }
}

/// The text of a file, which turns offsets into lines and columns.
#[derive(Clone, Copy)]
pub(crate) struct Source<'a> {
    pub(crate) text: &'a str,
}

impl Source<'_> {
    /// The problem `message` at the bytes `span`.
    pub(crate) fn problem(self, span: Range<usize>, path: String, message: String, help: Option<String>) -> Problem {
        let start = floor_char(self.text, span.start);
        let end = floor_char(self.text, span.end.max(start));
        let before = &self.text[..start];
        let line_start = before.rfind('\n').map_or(0, |i| i + 1);
        let line_end = self.text[start..].find('\n').map_or(self.text.len(), |i| start + i);
        let line = before.matches('\n').count() + 1;
        let column = self.text[line_start..start].chars().count();
        let length = self.text[start..end.min(line_end).max(start)].chars().count();
        let whole: Vec<char> = self.text[line_start..line_end].trim_end_matches('\r').chars().collect();
        let excerpt = Some(clip(&whole, column, length));
        Problem { path, line, column: column + 1, message, help, excerpt }
    }
}

/// The part of a line that holds the `length` characters from `column`, with blanks for what a terminal would act on.
fn clip(line: &[char], column: usize, length: usize) -> (String, usize, usize) {
    let from = if line.len() <= EXCERPT { 0 } else { column.saturating_sub(EXCERPT / 3).min(line.len()) };
    let to = line.len().min(from + EXCERPT);
    let text: String = line[from..to].iter().map(|&c| if c.is_control() { ' ' } else { c }).collect();
    let shown = column.saturating_sub(from);
    let marks = length.clamp(1, (to - from).saturating_sub(shown).max(1));
    (text, shown, marks)
}

fn floor_char(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// The candidate that `word` is most likely a slip of, if one is close enough.
pub(crate) fn nearest<'a>(word: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    // A word of more characters than any key is no slip, and comparing it would cost its length squared.
    if word.len() > 64 {
        return None;
    }
    let allowed = (word.chars().count() / 3).max(1);
    candidates
        .into_iter()
        .filter(|candidate| candidate.len() <= 64)
        .map(|candidate| (distance(word, candidate), candidate))
        .filter(|&(distance, _)| distance <= allowed && distance < word.chars().count())
        .min_by_key(|&(distance, _)| distance)
        .map(|(_, candidate)| candidate)
}

/// Edits between two words; one that holds the other, such as `length` and `rest_length`, counts as one edit.
fn distance(a: &str, b: &str) -> usize {
    let (a, b) = (a.to_lowercase().replace('-', "_"), b.to_lowercase().replace('-', "_"));
    let holds = a.len().min(b.len()) >= 4 && (a.contains(&b) || b.contains(&a));
    strsim::osa_distance(&a, &b).min(if holds { 1 } else { usize::MAX })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_become_lines_and_columns_of_characters() {
        let source = Source { text: "a = 1\r\nβ = \"x\"\r\n" };
        let at = source.text.find('"').expect("the text has a quote");
        let problem = source.problem(at..at + 3, "β".into(), "wrong".into(), None);
        assert_eq!((problem.line, problem.column), (2, 5));
        let shown = SceneError::new("f.toml", vec![problem]).to_string();
        assert_eq!(shown, "error: wrong\n --> f.toml:2:5 (β)\n  |\n2 | β = \"x\"\n  |     ^^^");
    }

    #[test]
    fn a_place_outside_the_text_is_its_end() {
        let problem = Source { text: "é" }.problem(1..99, String::new(), "wrong".into(), None);
        assert_eq!((problem.line, problem.column), (1, 1));
    }

    #[test]
    fn long_lines_are_clipped_around_the_place() {
        let text = format!("{}bad{}", "x".repeat(5000), "y".repeat(5000));
        let shown =
            SceneError::new("f", vec![Source { text: &text }.problem(5000..5003, String::new(), "m".into(), None)]);
        let shown = shown.to_string();
        assert!(shown.lines().all(|line| line.chars().count() < 130), "{shown}");
        assert!(shown.contains("xbad") && shown.contains("^^^"), "{shown}");
    }

    #[test]
    fn slips_find_their_word() {
        let keys = ["density", "radius", "stiffness", "rest_length"];
        assert_eq!(nearest("densty", keys), Some("density"));
        assert_eq!(nearest("Radius", keys), Some("radius"));
        assert_eq!(nearest("sitffness", keys), Some("stiffness"));
        assert_eq!(nearest("length", keys), Some("rest_length"));
        assert_eq!(nearest("colour", keys), None);
        assert_eq!(nearest(&"r".repeat(100_000), keys), None);
    }
}
