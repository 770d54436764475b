//! `polhode check`: the laws and the reference trajectories, measured.
//!
//! A check states a law, measures how far the engine is from it, and bounds that by a tolerance that gives its reason. It
//! uses the engine as a user does. Put to an engine that is wrong on purpose ([`Subject::with_integrator`]) the same checks
//! must fail, which is how the tests know that they can.

mod suite;
mod report;
mod json;
mod reference;
mod slope;
mod scene;

mod free;
mod gazebo;
mod orders;
mod heavy;
mod forces;
mod orbits;
mod conservation;
mod translation;
mod mass;
mod determinism;
mod pins;
mod lecture;

pub(crate) use report::draw;
pub use suite::{Check, Findings, Group, Measured, Subject, Table, Verdict, suite};

use crate::{Outcome, Progress, Refusal, Terminal};
use polhode::integrate::Integrator;

/// What to check, and how to say it.
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// Checks or groups of checks, by name; all when none is given. Named ones are reported in full
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Report for a machine
    #[arg(long)]
    json: bool,
    /// Name the checks and their laws, and run none
    #[arg(long)]
    list: bool,
    /// Put this integrator in the place of every other, to see checks fail
    #[arg(long, hide = true, value_name = "NAME")]
    with_integrator: Option<Integrator>,
}

impl Arguments {
    pub(crate) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        let checks = select(&self.names)?;
        if self.list {
            if self.json {
                json::list(terminal.out, &checks)?;
            } else {
                report::list(terminal.out, &checks)?;
            }
            return Ok(Outcome::Done);
        }
        let subject = self.with_integrator.map_or_else(Subject::default, Subject::with_integrator);
        let verdicts = run(&checks, subject);
        if self.json {
            json::verdicts(terminal.out, &verdicts)?;
        } else {
            report::verdicts(terminal.out, &verdicts, !self.names.is_empty())?;
        }
        Ok(if verdicts.iter().all(Verdict::passed) { Outcome::Done } else { Outcome::Failed })
    }
}

/// Runs checks one after the other.
pub fn run(checks: &[Check], subject: Subject) -> Vec<Verdict> {
    let progress = Progress::new(checks.len() as u64);
    checks
        .iter()
        .map(|check| {
            progress.say(check.name);
            let verdict = check.run(subject);
            progress.advance(1);
            verdict
        })
        .collect()
}

/// The checks of the given names or groups, in the order of the suite; all for no name.
fn select(names: &[String]) -> Result<Vec<Check>, Refusal> {
    let all = suite();
    let meant = |name: &str, check: &Check| check.name == name || check.group.name() == name;
    if let Some(unknown) = names.iter().find(|name| !all.iter().any(|check| meant(name, check))) {
        let known = Group::ALL.iter().map(|g| g.name()).chain(all.iter().map(|c| c.name));
        let near = nearest(unknown, known).map_or(String::new(), |name| format!("; did you mean `{name}`?"));
        return Err(Refusal::Input(format!(
            "no check and no group of checks is called `{unknown}`{near}\nAll names: polhode check --list"
        )));
    }
    Ok(all.into_iter().filter(|check| names.is_empty() || names.iter().any(|name| meant(name, check))).collect())
}

/// The known name that the fewest changes make of a mistyped one, if they are few.
fn nearest<'a>(typed: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    known.map(|name| (distance(typed, name), name)).filter(|&(d, name)| 3 * d <= name.len()).min().map(|(_, name)| name)
}

/// Levenshtein's distance: the insertions, removals and replacements between two words.
fn distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, ca) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, &cb) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(ca != cb);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}
