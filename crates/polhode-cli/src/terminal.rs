//! Where a command writes.

use anstyle::{AnsiColor, Style};
use std::io::Write;

/// Green: passed.
pub(crate) const GOOD: Style = AnsiColor::Green.on_default();
/// Red: failed.
pub(crate) const BAD: Style = AnsiColor::Red.on_default().bold();
/// Headings.
pub(crate) const HEADING: Style = Style::new().bold();
/// What may be skipped.
pub(crate) const FAINT: Style = Style::new().dimmed();

/// Standard output and standard error, or what stands for them.
///
/// Commands always write colours; a writer that is no terminal, such as [`anstream::AutoStream`] of a pipe, drops them.
pub struct Terminal<'a> {
    /// Results.
    pub out: &'a mut dyn Write,
    /// Complaints.
    pub err: &'a mut dyn Write,
}

impl<'a> Terminal<'a> {
    /// A terminal of two writers.
    pub fn new(out: &'a mut dyn Write, err: &'a mut dyn Write) -> Self {
        Self { out, err }
    }
    /// Says on standard error why a command could not do its work.
    pub fn complain(&mut self, why: &str) {
        // Where even this cannot be written, nobody is there to be told.
        let _ = writeln!(self.err, "{BAD}error:{BAD:#} {why}");
    }
}

/// `text` in a style.
pub(crate) fn styled(style: Style, text: &str) -> String {
    format!("{style}{text}{style:#}")
}
