//! Forces of a scene on single bodies, right or as the slides have them.

use crate::scene::{Force, Frame, Slide};
use polhode::field::{Anchor, BodyView, Field, Law, Spring, Wrench};
use polhode::math::Vec3;
use polhode::store::BodyId;

/// How a force at a point acts: as it does, or as the lecture's slides print it.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Formula {
    /// ṗ = F (F·r), in N²·m where N should be; the whole force moves the centre of mass, wherever it acts.
    projected: bool,
    /// τ = F × r, where r × F is right.
    reversed: bool,
}

impl Formula {
    pub(super) fn of(slides: &[Slide]) -> Self {
        Self { projected: slides.contains(&Slide::ForceProjection), reversed: slides.contains(&Slide::TorqueSign) }
    }

    pub(super) fn is_literal(self) -> bool {
        self.projected || self.reversed
    }

    /// The force `f` at `arm` from the centre of mass.
    pub(super) fn wrench(self, f: Vec3, arm: Vec3) -> Wrench {
        let right = Wrench::at(f, arm);
        Wrench {
            force: if self.projected { f * f.dot(arm) } else { right.force },
            torque: if self.reversed { f.cross(arm) } else { right.torque },
        }
    }
}

/// The vectors of a `[[force]]`, and the frames they are given in.
#[derive(Clone, Copy, Debug)]
pub(super) struct Push {
    at: Option<Vec3>,
    at_frame: Frame,
    frame: Frame,
    /// Force \[N\] or impulse \[N·s\].
    linear: Vec3,
    /// Torque \[N·m\] or angular impulse \[N·m·s\].
    angular: Vec3,
    formula: Formula,
}

impl Push {
    pub(super) fn force(force: &Force, formula: Formula) -> Self {
        Self::new(force, force.force, force.torque, formula)
    }
    pub(super) fn impulse(force: &Force, formula: Formula) -> Self {
        Self::new(force, force.impulse, force.angular_impulse, formula)
    }
    fn new(force: &Force, linear: Option<[f64; 3]>, angular: Option<[f64; 3]>, formula: Formula) -> Self {
        Self {
            at: force.at.map(Vec3::from),
            at_frame: force.at_frame,
            frame: force.frame,
            linear: linear.unwrap_or_default().into(),
            angular: angular.unwrap_or_default().into(),
            formula,
        }
    }

    /// Force and torque on a body where it is now, world axes.
    pub(super) fn wrench(&self, body: &BodyView) -> Wrench {
        let pose = body.pose();
        let turned = |v: Vec3| if self.frame == Frame::Body { pose.rot.rotate(v) } else { v };
        let point = match (self.at, self.at_frame) {
            (None, _) => body.x,
            (Some(point), Frame::Body) => pose.point(point),
            (Some(point), Frame::World) => point,
        };
        let mut wrench = self.formula.wrench(turned(self.linear), point - body.x);
        wrench.torque += turned(self.angular);
        wrench
    }
}

/// A force as a law that the integrator asks at each of its stages.
pub(super) fn lasting(force: &Force, formula: Formula, bodies: Vec<BodyId>) -> Field {
    let push = Push::force(force, formula);
    without_velocity(Field::custom(move |body: &BodyView| push.wrench(body))).only(bodies)
}

/// A spring from a body to the world that pulls by the slides' formulas.
pub(super) fn literal_spring(spring: Spring, body: BodyId, formula: Formula) -> Field {
    let own = move || if spring.a.body.is_some() { spring.a } else { spring.b };
    let law = move |body: &BodyView| {
        let wrench = pull(&spring, body);
        formula.wrench(wrench.force, own().state(Some(body)).arm)
    };
    let potential = move |body: &BodyView| {
        let (a, b) = sides(&spring, body);
        spring.potential(a, b)
    };
    let field = Field::conservative(law, potential).only([body]);
    if spring.damping == 0.0 { field } else { with_velocity(field) }
}

fn pull(spring: &Spring, body: &BodyView) -> Wrench {
    let (a, b) = sides(spring, body);
    let (on_a, on_b) = spring.wrenches(a, b);
    if a.is_some() { on_a } else { on_b }
}

fn sides<'a, 'b>(spring: &Spring, body: &'a BodyView<'b>) -> (Option<&'a BodyView<'b>>, Option<&'a BodyView<'b>>) {
    let on = |anchor: &Anchor| anchor.body.map(|_| body);
    (on(&spring.a), on(&spring.b))
}

fn without_velocity(mut field: Field) -> Field {
    if let Law::Custom(law) = &mut field.law {
        law.depends_on_velocity = false;
    }
    field
}

fn with_velocity(mut field: Field) -> Field {
    if let Law::Custom(law) = &mut field.law {
        law.depends_on_velocity = true;
    }
    field
}
