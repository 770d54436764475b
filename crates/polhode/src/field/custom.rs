//! A law of the user's own.

use super::{BodyView, Field, Law, Wrench};
use std::sync::Arc;

type WrenchLaw = dyn Fn(&BodyView) -> Wrench + Send + Sync;
type PotentialLaw = dyn Fn(&BodyView) -> f64 + Send + Sync;

/// A closure that is asked for the wrench on a body, several times a step: it must answer the same for the same view.
#[derive(Clone)]
pub struct Custom {
    wrench: Arc<WrenchLaw>,
    potential: Option<Arc<PotentialLaw>>,
    /// Whether the closure reads `v` or `w`; the default. A law of position alone saves two evaluations a step.
    pub depends_on_velocity: bool,
}

impl core::fmt::Debug for Custom {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Custom").field("depends_on_velocity", &self.depends_on_velocity).finish_non_exhaustive()
    }
}

impl Field {
    /// A law of the user's own, called from several threads when the world has several.
    ///
    /// A wrench that is not finite is left out, and the report of the step names the body.
    pub fn custom(wrench: impl Fn(&BodyView) -> Wrench + Send + Sync + 'static) -> Self {
        let law = Custom { wrench: Arc::new(wrench), potential: None, depends_on_velocity: true };
        Self { law: Law::Custom(law), only: None }
    }
    /// A law of position and orientation alone, with its potential energy \[J\].
    pub fn conservative(
        wrench: impl Fn(&BodyView) -> Wrench + Send + Sync + 'static,
        potential: impl Fn(&BodyView) -> f64 + Send + Sync + 'static,
    ) -> Self {
        let potential: Arc<PotentialLaw> = Arc::new(potential);
        let law = Custom { wrench: Arc::new(wrench), potential: Some(potential), depends_on_velocity: false };
        Self { law: Law::Custom(law), only: None }
    }
}

impl Custom {
    /// What the closure answers for the body.
    pub fn wrench(&self, body: &BodyView) -> Wrench {
        (self.wrench)(body)
    }
    /// The potential energy, 0 where the law has none \[J\].
    pub fn potential(&self, body: &BodyView) -> f64 {
        self.potential.as_ref().map_or(0.0, |p| p(body))
    }
}
