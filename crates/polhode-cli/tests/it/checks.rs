//! Every check passes on the engine, and fails on an engine that is wrong.

use polhode_cli::check::{Check, Group, Subject, run, suite};
use std::collections::BTreeSet;

fn of(group: Group) -> Vec<Check> {
    suite().into_iter().filter(|check| check.group == group).collect()
}

/// Runs a group, and fails with every figure that is beyond its bound.
fn all_pass(group: Group) {
    let mut complaints = Vec::new();
    for verdict in run(&of(group), Subject::default()) {
        let name = verdict.check.name;
        match &verdict.findings {
            Err(error) => complaints.push(format!("{name}: {error}")),
            Ok(findings) => {
                let beyond = findings.measured.iter().filter(|m| !m.passed());
                complaints.extend(beyond.map(|m| format!("{name}: {}: {:e} > {:e}", m.what, m.error, m.tolerance)));
                if findings.measured.is_empty() {
                    complaints.push(format!("{name}: measured nothing"));
                }
            }
        }
    }
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

/// The checks that measure too large an error when `integrator` stands for every other. One that cannot be measured at all
/// does not count.
fn caught(integrator: &str, names: &[&str]) {
    let subject = Subject::with_integrator(integrator.parse().expect("an integrator"));
    let checks: Vec<Check> = suite().into_iter().filter(|check| names.contains(&check.name)).collect();
    assert_eq!(checks.len(), names.len(), "a name of {names:?} is of no check");
    for verdict in run(&checks, subject) {
        let name = verdict.check.name;
        let findings = verdict.findings.unwrap_or_else(|e| panic!("{name} with {integrator}: {e}"));
        assert!(findings.measured.iter().any(|m| !m.passed()), "{name} passes with {integrator}");
    }
}

#[test]
fn free_bodies_pass() {
    all_pass(Group::Free);
}
#[test]
fn heavy_tops_pass() {
    all_pass(Group::Heavy);
}
#[test]
fn forces_pass() {
    all_pass(Group::Forces);
}
#[test]
fn translation_passes() {
    all_pass(Group::Translation);
}
#[test]
fn mass_passes() {
    all_pass(Group::Mass);
}
#[test]
fn determinism_passes() {
    all_pass(Group::Determinism);
}
#[test]
fn pins_pass() {
    all_pass(Group::Pins);
}
#[test]
fn the_lecture_passes() {
    all_pass(Group::Lecture);
}

#[test]
fn explicit_euler_is_caught_wherever_something_moves() {
    caught("explicit-euler", &["free-hv", "free-exact", "free-periods", "gazebo"]);
    caught("explicit-euler", &["heavy-lagrange"]);
    caught("explicit-euler", &["drag-linear", "oscillator-damped", "torsion-pendulum", "buoyancy", "work", "kepler"]);
    caught("explicit-euler", &["parabola", "oscillator-invariants", "oscillator-phase"]);
    caught("explicit-euler", &["reversal"]);
    caught("explicit-euler", &["lecture-21-velocity", "lecture-25-frames"]);
}

#[test]
fn a_rotation_of_first_order_is_caught_on_pins() {
    caught("verlet", &["heavy-bruls", "heavy-bruls-twice", "pendulum-periods", "pendulum-conical", "hinge"]);
    caught("verlet", &["lecture-29-gyroscope"]);
}

#[test]
fn a_map_without_preprocessing_is_caught() {
    caught("dmv", &["free-hv", "free-box", "free-water", "free-dzhanibekov", "free-hard", "orders"]);
}

#[test]
fn the_slides_are_caught() {
    caught("slides", &["mass-particles", "mass-50-matrix"]);
    caught("slides", &["lecture-04-rigid", "lecture-28-torque", "lecture-40-puck"]);
}

#[test]
fn a_scheme_that_drifts_is_caught_by_its_energy() {
    caught("splitting", &["free-million"]);
    caught("rk4", &["oscillator-invariants", "kepler"]);
}

#[test]
fn names_and_sentences_are_fit_to_be_read() {
    let checks = suite();
    let mut names: Vec<&str> = checks.iter().map(|check| check.name).collect();
    names.extend(Group::ALL.iter().map(|group| group.name()));
    let distinct: BTreeSet<&str> = names.iter().copied().collect();
    assert_eq!(distinct.len(), names.len(), "a name means one thing: {names:?}");
    for check in checks {
        assert!(check.law.ends_with('.') && check.law.starts_with(|c: char| !c.is_lowercase()), "{}", check.law);
        assert!(check.name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-'), "{}", check.name);
    }
    for group in Group::ALL {
        assert!(!of(group).is_empty(), "{group} has no check");
    }
}
