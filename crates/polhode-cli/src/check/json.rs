//! The report for a machine.

use super::suite::{Check, Measured, Table, Verdict};
use serde_json::{Value, json};
use std::io::{self, Write};

/// `[{group, name, law}]`.
pub(super) fn list(out: &mut dyn Write, checks: &[Check]) -> io::Result<()> {
    print(out, &checks.iter().map(description).collect())
}

/// `{version, passed, seconds, checks}`. An error or tolerance that is no finite number is null.
pub(super) fn verdicts(out: &mut dyn Write, verdicts: &[Verdict]) -> io::Result<()> {
    let report = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "passed": verdicts.iter().all(Verdict::passed),
        "seconds": verdicts.iter().map(|v| v.seconds).sum::<f64>(),
        "checks": verdicts.iter().map(verdict).collect::<Vec<_>>(),
    });
    print(out, &report)
}

fn description(check: &Check) -> Value {
    json!({ "group": check.group.name(), "name": check.name, "law": check.law })
}

fn verdict(verdict: &Verdict) -> Value {
    let mut value = description(&verdict.check);
    value["passed"] = verdict.passed().into();
    value["seconds"] = verdict.seconds.into();
    match &verdict.findings {
        Ok(findings) => {
            value["measured"] = findings.measured.iter().map(measured).collect();
            value["table"] = findings.table.as_ref().map_or(Value::Null, table);
        }
        Err(error) => value["failure"] = error.to_string().into(),
    }
    value
}

fn measured(m: &Measured) -> Value {
    json!({
        "what": m.what,
        "error": m.error,
        "tolerance": m.tolerance,
        "because": m.because,
        "passed": m.passed(),
    })
}

pub(crate) fn table(table: &Table) -> Value {
    json!({ "columns": table.columns, "rows": table.rows, "note": table.note })
}

/// Pretty, with a line end.
pub(crate) fn print(out: &mut dyn Write, value: &Value) -> io::Result<()> {
    writeln!(out, "{value:#}")
}
