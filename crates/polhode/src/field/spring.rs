//! A spring and damper between two points: Hooke's law along the line that joins them.

use super::{Anchor, BodyView, Field, Law, Wrench, at_least, finite};
use crate::Error;

/// Pulls its two ends together with k (|d| − l0) + c ḋ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// One end.
    pub a: Anchor,
    /// The other end.
    pub b: Anchor,
    /// k \[N/m\], at least 0.
    pub stiffness: f64,
    /// c [N·s/m], at least 0.
    pub damping: f64,
    /// l0 \[m\], at least 0.
    pub rest_length: f64,
}

impl Field {
    /// A spring of `stiffness` \[N/m\] and `rest_length` \[m\] between two points, undamped.
    pub fn spring(a: Anchor, b: Anchor, stiffness: f64, rest_length: f64) -> Self {
        Self { law: Law::Spring(Spring { a, b, stiffness, damping: 0.0, rest_length }), only: None }
    }
    /// The damping of a spring [N·s/m] or of a torsion spring [N·m·s/rad]; other laws have none.
    pub fn damping(mut self, damping: f64) -> Self {
        match &mut self.law {
            Law::Spring(s) => s.damping = damping,
            Law::TorsionSpring(s) => s.damping = damping,
            _ => {}
        }
        self
    }
}

impl Spring {
    /// The wrenches on the bodies of `a` and `b`.
    ///
    /// Ends in one point have no direction: then a spring with a rest length pushes nowhere and a damper brakes the
    /// whole relative velocity, which is the limit of zero length.
    pub fn wrenches(&self, a: Option<&BodyView>, b: Option<&BodyView>) -> (Wrench, Wrench) {
        let (a, b) = (self.a.state(a), self.b.state(b));
        let d = b.x - a.x;
        let v = b.v - a.v;
        let length = d.length();
        let on_a = if length == 0.0 {
            v * self.damping
        } else {
            let u = d / length;
            u * (self.stiffness * (length - self.rest_length) + self.damping * u.dot(v))
        };
        (Wrench::at(on_a, a.arm), Wrench::at(-on_a, b.arm))
    }
    /// ½ k (|d| − l0)² \[J\].
    pub fn potential(&self, a: Option<&BodyView>, b: Option<&BodyView>) -> f64 {
        let stretch = (self.b.state(b).x - self.a.state(a).x).length() - self.rest_length;
        0.5 * self.stiffness * stretch * stretch
    }
    pub(super) fn validate(&self) -> Result<(), Error> {
        finite("a.point", self.a.point)?;
        finite("b.point", self.b.point)?;
        at_least("stiffness", self.stiffness, 0.0, "N/m")?;
        at_least("damping", self.damping, 0.0, "N·s/m")?;
        at_least("rest_length", self.rest_length, 0.0, "m")
    }
}
