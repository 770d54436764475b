//! The report for a reader.

use super::suite::{Check, Findings, Measured, Table, Verdict};
use crate::terminal::{BAD, FAINT, GOOD, HEADING, styled};
use std::io::{self, Write};

/// A line a check, under the name of its group.
pub(super) fn list(out: &mut dyn Write, checks: &[Check]) -> io::Result<()> {
    let width = checks.iter().map(|c| c.name.len()).max().unwrap_or(0);
    for group in checks.chunk_by(|a, b| a.group == b.group) {
        writeln!(out, "{}", styled(HEADING, group[0].group.name()))?;
        for check in group {
            writeln!(out, "  {:width$}  {}", check.name, check.law)?;
        }
    }
    Ok(())
}

/// A line a check, or all of its figures where it was asked for by name or did not pass.
pub(super) fn verdicts(out: &mut dyn Write, verdicts: &[Verdict], in_full: bool) -> io::Result<()> {
    let mut group = None;
    let width = verdicts.iter().map(|v| v.check.name.len()).max().unwrap_or(0);
    for verdict in verdicts {
        if in_full || !verdict.passed() {
            full(out, verdict)?;
            group = None;
            continue;
        }
        if group != Some(verdict.check.group) {
            group = Some(verdict.check.group);
            writeln!(out, "{}", styled(HEADING, verdict.check.group.name()))?;
        }
        line(out, verdict, width)?;
    }
    summary(out, verdicts)
}

/// The figure of a check that is nearest to its bound.
fn line(out: &mut dyn Write, verdict: &Verdict, width: usize) -> io::Result<()> {
    let Ok(findings) = &verdict.findings else { return Ok(()) };
    let Some(worst) = findings.measured.iter().max_by(|a, b| a.share().total_cmp(&b.share())) else { return Ok(()) };
    let others = match findings.measured.len() {
        1 => String::new(),
        n => styled(FAINT, &format!(" (nearest of {n})")),
    };
    writeln!(
        out,
        "  {}  {:width$}  {:>7} ≤ {:<7}  {:5.2} s  {}{others}",
        styled(GOOD, "ok"),
        verdict.check.name,
        figure(worst.error),
        figure(worst.tolerance),
        verdict.seconds,
        worst.what,
    )
}

/// Everything that is known of a check.
fn full(out: &mut dyn Write, verdict: &Verdict) -> io::Result<()> {
    let Verdict { check, findings, seconds } = verdict;
    let mark = if verdict.passed() { styled(GOOD, "ok") } else { styled(BAD, "FAILED") };
    writeln!(out, "{}  {mark}  {seconds:.2} s  {}", styled(HEADING, check.name), styled(FAINT, check.group.name()))?;
    writeln!(out, "  {}", check.law)?;
    match findings {
        Err(error) => writeln!(out, "  {} {error}", styled(BAD, "could not be measured:"))?,
        Ok(findings) => figures(out, findings)?,
    }
    writeln!(out)
}

fn figures(out: &mut dyn Write, findings: &Findings) -> io::Result<()> {
    // A reason that several figures share stands once, below the last of them.
    for same in findings.measured.chunk_by(|a, b| a.because == b.because) {
        for figure @ Measured { what, error, tolerance, .. } in same {
            let mark = if figure.passed() { styled(GOOD, "ok    ") } else { styled(BAD, "FAILED") };
            writeln!(out, "  {mark} {:>7} ≤ {:<7}  {what}", self::figure(*error), self::figure(*tolerance))?;
        }
        writeln!(out, "{:28}{}", "", styled(FAINT, &same[0].because))?;
    }
    match &findings.table {
        Some(table) => writeln!(out).and_then(|()| draw(out, table)),
        None => Ok(()),
    }
}

/// Columns as wide as their widest cell; the first to the left, numbers to the right.
pub(crate) fn draw(out: &mut dyn Write, table: &Table) -> io::Result<()> {
    let count = |text: &str| text.chars().count();
    let widths: Vec<usize> = (0..table.columns.len())
        .map(|i| table.rows.iter().map(|row| count(&row[i])).chain([count(table.columns[i])]).max().unwrap_or(0))
        .collect();
    let row = |cells: &mut dyn Iterator<Item = &str>| -> String {
        let mut text = String::new();
        for (i, (cell, &width)) in cells.zip(&widths).enumerate() {
            let gap = " ".repeat(width - count(cell));
            text.extend(if i == 0 { ["  ", cell, &gap] } else { ["  ", &gap, cell] });
        }
        text.trim_end().to_string()
    };
    writeln!(out, "{}", styled(HEADING, &row(&mut table.columns.iter().copied())))?;
    for cells in &table.rows {
        writeln!(out, "{}", row(&mut cells.iter().map(String::as_str)))?;
    }
    if table.note.is_empty() {
        return Ok(());
    }
    writeln!(out, "  {}", styled(FAINT, table.note))
}

fn summary(out: &mut dyn Write, verdicts: &[Verdict]) -> io::Result<()> {
    let seconds: f64 = verdicts.iter().map(|v| v.seconds).sum();
    let figures: usize = verdicts.iter().filter_map(|v| v.findings.as_ref().ok()).map(|f| f.measured.len()).sum();
    let failed: Vec<&str> = verdicts.iter().filter(|v| !v.passed()).map(|v| v.check.name).collect();
    let what = format!("{} checks, {figures} figures, {seconds:.1} s:", verdicts.len());
    if failed.is_empty() {
        return writeln!(out, "{what} {}", styled(GOOD, "all passed"));
    }
    writeln!(out, "{what} {} {}", styled(BAD, &format!("{} failed:", failed.len())), failed.join(", "))
}

/// Two digits, in a width that does not jump.
pub(super) fn figure(x: f64) -> String {
    if x == 0.0 { "0".to_string() } else { format!("{x:.1e}") }
}
