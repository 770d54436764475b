//! What moves, and what pushes it: position, orientation, linear and angular momentum.
//!
//! A snapshot of a world is a copy of its [`State`].

use crate::field::BodyView;
use crate::integrate::Phase;
use crate::math::{Mat3, Vec3};
use crate::model::Model;

/// Everything that a step changes and the next step needs.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct State {
    /// Simulated time \[s\]; written by stage `rest`.
    pub time: f64,
    /// What rounding took from `time` \[s\] (compensated sum); written by stage `rest`.
    pub time_error: f64,
    /// Number of steps taken; written by stage `rest`.
    pub steps: u64,
    /// x rot p l of every body, in slot order; written by stage `substep`. A kinematic body has unit mass and inertia: its
    /// p and l are its prescribed velocities.
    pub bodies: Phase,
    /// The matrix R of every body where the integrator keeps one and lets it drift from a rotation; otherwise empty.
    /// Written by stage `substep`.
    pub matrix: Vec<Mat3>,
    /// The impulse µ of the last closing half of each pin, world [N·s] (n_pins). Written by stage `substep`.
    pub pin_closing: Vec<Vec3>,
    /// All impulses of each pin in the last step, world [N·s] (n_pins): the mean reaction times the step. Written by stage
    /// `substep`.
    pub pin_impulse: Vec<Vec3>,
    /// The last step \[s\]; 0 before the first. Written by stage `rest`.
    pub last_step: f64,
    /// How often bodies or pins had been added or removed: a state fits a world of the same history.
    pub revision: u64,
}

impl State {
    /// The simulated time, to the last bit \[s\].
    pub fn now(&self) -> f64 {
        self.time + self.time_error
    }
}

/// What the user pushes with, besides the fields: constant in world axes over a step.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Inputs {
    /// Sum of the applied forces, world \[N\] (n_bodies).
    pub force: Vec<Vec3>,
    /// Sum of the applied torques about the centres of mass, world [N·m] (n_bodies).
    pub torque: Vec<Vec3>,
    /// Whether any of them may be other than zero.
    pub any: bool,
    /// Whether they stay for the next steps; the default is that each step clears them.
    pub keep: bool,
}

impl Inputs {
    /// Forgets all forces and torques.
    pub fn clear(&mut self) {
        if self.any {
            self.force.fill(Vec3::ZERO);
            self.torque.fill(Vec3::ZERO);
            self.any = false;
        }
    }
}

/// What a law of force may know of the body in `slot`.
#[inline]
pub fn view<'a>(model: &'a Model, bodies: &Phase, time: f64, slot: usize) -> BodyView<'a> {
    let (rot, l) = (bodies.rot[slot], bodies.l[slot]);
    let dynamic = slot < model.n_dynamic();
    BodyView {
        id: model.slots.ids()[slot],
        time,
        mass: if dynamic { model.mass[slot] } else { 0.0 },
        inertia: model.inertia[slot],
        x: bodies.x[slot],
        rot,
        v: bodies.p[slot] * model.inv_mass[slot],
        w: angular_velocity(rot, l, model.inv_inertia[slot]),
        frame: model.frame[slot],
        shapes: &model.shapes[slot],
        gravity: model.gravity,
    }
}

/// ω = R J0⁻¹ Rᵀ L, world \[rad/s\].
#[inline]
pub fn angular_velocity(rot: crate::math::Quat, l: Vec3, inv_inertia: Vec3) -> Vec3 {
    rot.rotate(rot.inverse_rotate(l).scale(inv_inertia))
}
