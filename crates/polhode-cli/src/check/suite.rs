//! What a check is, and how one is run.

use super::{conservation, determinism, forces, free, gazebo, heavy, lecture, mass, orbits, orders, pins, translation};
use polhode::integrate::{Drift, Integrator};
use polhode::{Error, World};
use std::fmt;
use std::time::Instant;

/// What a check belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Rotation of bodies that nothing pushes.
    Free,
    /// Tops in gravity.
    Heavy,
    /// Motion under the laws of force.
    Forces,
    /// Motion of the centre of mass.
    Translation,
    /// Mass, centre and inertia.
    Mass,
    /// The same bits again.
    Determinism,
    /// Bodies that are held at a point.
    Pins,
    /// Statements of the lecture, in their right form.
    Lecture,
}

impl Group {
    /// In the order in which they are run.
    pub const ALL: [Self; 8] = [
        Self::Free,
        Self::Heavy,
        Self::Forces,
        Self::Translation,
        Self::Mass,
        Self::Determinism,
        Self::Pins,
        Self::Lecture,
    ];
    /// As it is typed.
    pub fn name(self) -> &'static str {
        match self {
            Self::Free => "free",
            Self::Heavy => "heavy",
            Self::Forces => "forces",
            Self::Translation => "translation",
            Self::Mass => "mass",
            Self::Determinism => "determinism",
            Self::Pins => "pins",
            Self::Lecture => "lecture",
        }
    }
}

impl fmt::Display for Group {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// One law or reference, and how it is measured.
#[derive(Clone, Copy, Debug)]
pub struct Check {
    /// What it belongs to.
    pub group: Group,
    /// As it is typed.
    pub name: &'static str,
    /// What must hold, in a sentence.
    pub law: &'static str,
    /// Measures it.
    pub measure: fn(Subject) -> Result<Findings, Error>,
}

/// What is put to the test: the engine as it is, or, for a negative control, with one integrator in the place of all.
#[derive(Clone, Copy, Debug, Default)]
pub struct Subject {
    substitute: Option<Integrator>,
}

impl Subject {
    /// The engine in which `integrator` stands for every other. With the lecture's slides as the integrator, the slides'
    /// formulas of force and inertia are used too. Checks must fail on it.
    pub fn with_integrator(integrator: Integrator) -> Self {
        Self { substitute: Some(integrator) }
    }
    /// The integrator of a name, or what stands for it.
    pub(super) fn integrator(self, name: &str) -> Result<Integrator, Error> {
        self.substitute.map_or_else(|| name.parse(), Ok)
    }
    /// The free rotation that an integrator is made of; a coupled one is stood for by exp(h ω) with ω frozen, its order 1.
    pub(super) fn drift(self, name: &str) -> Result<Drift, Error> {
        Ok(match self.integrator(name)? {
            Integrator::Split { drift, .. } => drift,
            Integrator::Coupled(_) => Drift::Exponential,
        })
    }
    /// A world without gravity.
    pub(super) fn world(self, integrator: &str) -> Result<World, Error> {
        self.prepare(World::new(), integrator)
    }
    /// A world in the plane, without gravity.
    pub(super) fn planar_world(self, integrator: &str) -> Result<World, Error> {
        self.prepare(World::planar(), integrator)
    }
    fn prepare(self, mut world: World, integrator: &str) -> Result<World, Error> {
        world.set_gravity([0.0; 3])?;
        world.set_integrator(self.integrator(integrator)?)?;
        Ok(world)
    }
    /// Whether the formulas that the slides got wrong are used as printed.
    pub(super) fn as_on_the_slides(self) -> bool {
        self.substitute.is_some_and(|i| "slides".parse().is_ok_and(|slides: Integrator| i == slides))
    }
}

/// One figure and its bound.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// What was measured, with its unit.
    pub what: String,
    /// The deviation from the law.
    pub error: f64,
    /// The largest deviation that passes.
    pub tolerance: f64,
    /// Why it is not smaller and need not be larger.
    pub because: String,
}

impl Measured {
    /// Whether the figure keeps to its bound. What is no number does not, nor does anything to a bound without end.
    pub fn passed(&self) -> bool {
        self.tolerance.is_finite() && self.error <= self.tolerance
    }
    /// How much of the tolerance is used up.
    pub fn share(&self) -> f64 {
        match (self.passed(), self.error == 0.0) {
            (true, true) => 0.0,
            (true, false) => self.error / self.tolerance,
            (false, _) => f64::INFINITY,
        }
    }
}

/// Figures for the eye.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Table {
    /// Headings.
    pub columns: Vec<&'static str>,
    /// As many cells as there are headings, each.
    pub rows: Vec<Vec<String>>,
    /// What the columns mean.
    pub note: &'static str,
}

/// What a check measured.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Findings {
    /// Every figure with its bound.
    pub measured: Vec<Measured>,
    /// More figures, without bounds.
    pub table: Option<Table>,
}

impl Findings {
    /// Adds a figure.
    pub(super) fn at_most(
        &mut self,
        what: impl Into<String>,
        error: f64,
        tolerance: f64,
        because: impl Into<String>,
    ) -> &mut Self {
        self.measured.push(Measured { what: what.into(), error, tolerance, because: because.into() });
        self
    }
    /// Adds the figure that was nearest to its bound, if there was any.
    pub(super) fn worst(&mut self, worst: Worst) -> &mut Self {
        self.measured.extend(worst.0);
        self
    }
    /// Adds a count of things that must not be.
    pub(super) fn none(&mut self, what: impl Into<String>, count: usize, because: impl Into<String>) -> &mut Self {
        self.at_most(what, count as f64, 0.0, because)
    }
}

/// Of many figures the one that is nearest to its bound.
#[derive(Clone, Debug, Default)]
pub(super) struct Worst(Option<Measured>);

impl Worst {
    /// Keeps the figure if none was nearer.
    pub(super) fn see(
        &mut self,
        what: impl Into<String>,
        error: f64,
        tolerance: f64,
        because: impl Into<String>,
    ) -> &mut Self {
        let figure = Measured { what: what.into(), error, tolerance, because: because.into() };
        if self.0.as_ref().is_none_or(|worst| worst.share() <= figure.share()) {
            self.0 = Some(figure);
        }
        self
    }
}

/// A check that was run.
#[derive(Clone, Debug)]
pub struct Verdict {
    /// The check.
    pub check: Check,
    /// What it measured, or why it could not.
    pub findings: Result<Findings, Error>,
    /// Wall time \[s\].
    pub seconds: f64,
}

impl Verdict {
    /// Whether all figures keep to their bounds, and there are some.
    pub fn passed(&self) -> bool {
        self.findings.as_ref().is_ok_and(|f| !f.measured.is_empty() && f.measured.iter().all(Measured::passed))
    }
}

impl Check {
    /// Runs the check.
    pub fn run(&self, subject: Subject) -> Verdict {
        let start = Instant::now();
        let findings = (self.measure)(subject);
        Verdict { check: *self, findings, seconds: start.elapsed().as_secs_f64() }
    }
}

/// All checks, group by group.
pub fn suite() -> Vec<Check> {
    let modules: [&[Check]; 12] = [
        free::CHECKS,
        gazebo::CHECKS,
        orders::CHECKS,
        heavy::CHECKS,
        forces::CHECKS,
        orbits::CHECKS,
        conservation::CHECKS,
        translation::CHECKS,
        mass::CHECKS,
        determinism::CHECKS,
        pins::CHECKS,
        lecture::CHECKS,
    ];
    let mut all = modules.concat();
    all.sort_by_key(|check| Group::ALL.iter().position(|&group| group == check.group));
    all
}

#[cfg(test)]
mod tests {
    use super::super::scene::Greatest;
    use super::*;

    fn figure(error: f64, tolerance: f64) -> Measured {
        Measured { what: String::new(), error, tolerance, because: String::new() }
    }

    #[test]
    fn what_is_no_number_passes_nowhere() {
        assert!(figure(1.0, 1.0).passed() && figure(0.0, 0.0).passed());
        for (error, tolerance) in [(f64::NAN, 1.0), (1.0, f64::NAN), (f64::INFINITY, f64::INFINITY), (2.0, 1.0)] {
            assert!(!figure(error, tolerance).passed(), "{error} {tolerance}");
        }
        assert!(f64::NAN.greatest(1.0).is_nan() && 1.0_f64.greatest(f64::NAN).is_nan());
        assert_eq!((2.0_f64.greatest(1.0), 1.0_f64.greatest(2.0)), (2.0, 2.0));
    }

    #[test]
    fn the_worst_figure_is_the_one_nearest_to_its_bound() {
        let mut worst = Worst::default();
        for (what, error, tolerance) in [("far", 1.0, 10.0), ("near", 0.9, 1.0), ("none", 0.0, 0.0)] {
            worst.see(what, error, tolerance, "");
        }
        assert_eq!(worst.0.as_ref().map(|m| m.what.as_str()), Some("near"));
        worst.see("beyond", f64::NAN, 1.0, "").see("within", 1.0, 1.0, "");
        assert_eq!(worst.0.map(|m| m.what), Some("beyond".to_string()));
    }
}
