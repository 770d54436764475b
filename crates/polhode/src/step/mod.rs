//! One step of a world: the only module that knows the order.
//!
//! [`step`] reads as the list of stages; an argument's `&` or `&mut` is all that a stage may touch.

mod forces;
mod closing;
mod split;
mod coupled;
mod ledger;
mod scratch;

pub use ledger::{Energy, angular_momentum, energy, momentum};
pub use scratch::Scratch;

use crate::integrate::Integrator;
use crate::math::Vec3;
use crate::model::Model;
use crate::par::Executor;
use crate::solve::pins::Residual;
use crate::state::{Inputs, State, view};
use crate::store::BodyId;

/// What a step did.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Report {
    /// Simulated time after the step \[s\].
    pub time: f64,
    /// Bodies that forces move.
    pub bodies: usize,
    /// How far the pinned points were from closed, and the Newton steps that it took.
    pub pins: Residual,
    /// Whether an adaptive integrator's step vanished before it came to the end: the bodies are where it came.
    pub stalled: bool,
    /// Bodies whose velocity-dependent forces could not be solved for; their motion in this step is not to be trusted.
    pub unconverged: usize,
    /// Bodies on which a law gave a wrench that was not finite: that law was left out for them, and all else went on.
    pub quarantined: Vec<BodyId>,
    /// The energy after the step, where the world is audited.
    pub energy: Option<Energy>,
}

/// Advances a world by `dt` \[s\].
///
/// Stepping does not fail: what went wrong is in the report.
pub fn step(
    model: &Model,
    inputs: &mut Inputs,
    state: &mut State,
    scratch: &mut Scratch,
    executor: &Executor,
    dt: f64,
) -> Report {
    scratch.begin(model);
    let moving = Moving { model, inputs, state, scratch, executor };
    let moved = match model.integrator {
        Integrator::Split { drift, kick, composition } => {
            Moved { pins: split::advance(moving, drift, kick, composition, dt), dt }
        }
        Integrator::Coupled(scheme) => Moved { pins: Residual::default(), dt: coupled::advance(moving, scheme, dt) },
    };
    rest(model, inputs, state, scratch, &moved, dt)
}

/// What stage 7 did.
struct Moved {
    pins: Residual,
    /// How far it came \[s\]: less than was asked for where an adaptive method gave up.
    dt: f64,
}

/// What stage 7 may touch.
struct Moving<'a> {
    model: &'a Model,
    inputs: &'a Inputs,
    state: &'a mut State,
    scratch: &'a mut Scratch,
    executor: &'a Executor,
}

/// Stage 9: the clock, the user's forces, and the report.
fn rest(model: &Model, inputs: &mut Inputs, state: &mut State, scratch: &Scratch, moved: &Moved, asked: f64) -> Report {
    // Neumaier's sum: a clock of a million steps is right to the last bit.
    let dt = moved.dt;
    let time = state.time + dt;
    state.time_error += if state.time.abs() >= dt.abs() { (state.time - time) + dt } else { (dt - time) + state.time };
    state.time = time;
    state.steps += 1;
    state.last_step = dt;
    if !inputs.keep {
        inputs.clear();
    }
    let refused = scratch.refused.iter().enumerate().filter(|(_, refused)| **refused);
    Report {
        time: state.now(),
        bodies: model.n_dynamic(),
        pins: moved.pins,
        stalled: dt != asked,
        unconverged: scratch.unconverged,
        quarantined: refused.map(|(slot, _)| model.slots.ids()[slot]).collect(),
        energy: None,
    }
}

/// Takes the motion of a body that was just pinned to what its pins allow: the impulses of a bearing that closes on it.
pub fn settle_pins(model: &Model, state: &mut State, scratch: &mut Scratch, body: BodyId) {
    let Some(slot) = model.slots.slot(body) else { return };
    let pins = model.pins_of(body);
    scratch.begin(model);
    let mut pinned = split::pinned(model, &mut state.bodies, slot);
    let point = |i: usize| split::point(model, pins.start + i);
    let closing = &mut state.pin_closing[pins.clone()];
    pinned.close_velocities(point, closing, &mut scratch.rows);
    // That impulse was a collision, not a load: the next step must not start from it.
    closing.fill(Vec3::ZERO);
}

/// Force \[N\] and torque about the centre of mass [N·m] that act on a body now, without the reactions of pins.
pub fn wrench(model: &Model, inputs: &Inputs, state: &State, slot: usize) -> crate::field::Wrench {
    if slot >= model.n_dynamic() {
        return crate::field::Wrench::ZERO;
    }
    forces::wrench(model, inputs, &state.bodies, state.now(), slot)
}

/// The velocity of the centre of mass \[m/s\] and the angular velocity \[rad/s\] of a body, world.
pub fn velocities(model: &Model, state: &State, slot: usize) -> (Vec3, Vec3) {
    let body = view(model, &state.bodies, state.now(), slot);
    (body.v, body.w)
}
