//! Stage 7 for the schemes that evaluate all rates together.

use super::Moving;
use super::forces::forces;
use super::scratch::Scratch;
use crate::integrate::dormand_prince::Settings;
use crate::integrate::phase::{Law, Phase, Rates};
use crate::integrate::phase_solver::PhaseSolver;
use crate::integrate::{
    Coupled, buss, commutator_free, crouch_grossman, explicit_euler, explicit_matrix, lie_midpoint, rk4, rkmk4,
};
use crate::math::Vec3;
use crate::model::Model;
use crate::state::angular_velocity;

/// Advances all bodies over `dt` \[s\], with the forces evaluated at the stages of the scheme. Returns how far it came \[s\].
pub(super) fn advance(moving: Moving, scheme: Coupled, dt: f64) -> f64 {
    let Moving { model, inputs, state, scratch, executor } = moving;
    // The schemes' storage is lent to the scheme, the rest of the scratch to the law that it calls.
    let mut work = core::mem::take(&mut scratch.work);
    let (time, bodies) = (state.now(), &mut state.bodies);
    let mut reached = dt;
    let mut law = |t: f64, y: &Phase, rates: &mut Rates| {
        forces(model, inputs, y, t, executor, scratch);
        self::rates(model, y, scratch, rates);
    };
    match scheme {
        Coupled::ExplicitEuler => explicit_euler::step(&mut law, time, dt, bodies, &mut work),
        Coupled::ExplicitMatrix { gram_schmidt } => {
            let scheme = explicit_matrix::ExplicitMatrix { inertia: &model.inertia, gram_schmidt };
            scheme.step(&mut law, (time, dt), bodies, &mut state.matrix, &mut work);
        }
        Coupled::Buss => buss::Buss { inertia: &model.inertia }.step(&mut law, time, dt, bodies, &mut work),
        Coupled::LieMidpoint => lie_midpoint::step(&mut law, time, dt, bodies, &mut work),
        Coupled::Rk4 => rk4::step(&mut law, time, dt, bodies, &mut work),
        Coupled::Rkmk4 => rkmk4::step(&mut law, time, dt, bodies, &mut work),
        Coupled::CrouchGrossman3 => crouch_grossman::step(&mut law, time, dt, bodies, &mut work),
        Coupled::CommutatorFree4 => commutator_free::step(&mut law, time, dt, bodies, &mut work),
        Coupled::DormandPrince => reached = dormand_prince(&mut law, time, dt, bodies),
    }
    scratch.work = work;
    reached
}

/// As far as the adaptive method comes: where its step vanishes, the bodies stay at the last accepted one.
fn dormand_prince(law: &mut Law<'_>, time: f64, dt: f64, bodies: &mut Phase) -> f64 {
    // It counts time from the start of the step, so that a late clock does not coarsen it.
    let mut law = |t: f64, y: &Phase, rates: &mut Rates| law(time + t, y, rates);
    let Ok(mut solver) = PhaseSolver::new(Settings::tolerance(1e-13), 0.0, bodies) else { return 0.0 };
    let arrived = solver.advance(&mut law, dt).is_ok();
    bodies.copy_from(solver.phase());
    if arrived { dt } else { solver.t() }
}

/// v = p/m, ω = R J0⁻¹ Rᵀ L, and the wrench of each dynamic body.
fn rates(model: &Model, y: &Phase, scratch: &Scratch, rates: &mut Rates) {
    rates.force.fill(Vec3::ZERO);
    rates.torque.fill(Vec3::ZERO);
    for slot in 0..model.n_moving() {
        rates.v[slot] = y.p[slot] * model.inv_mass[slot];
        rates.w[slot] = angular_velocity(y.rot[slot], y.l[slot], model.inv_inertia[slot]);
    }
    for slot in model.n_moving()..model.slots.len() {
        (rates.v[slot], rates.w[slot]) = (Vec3::ZERO, Vec3::ZERO);
    }
    for slot in 0..model.n_dynamic() {
        if scratch.only_gravity {
            rates.force[slot] = model.gravity * (model.mass[slot] * model.gravity_scale[slot]);
            continue;
        }
        (rates.force[slot], rates.torque[slot]) = (scratch.force[slot], scratch.torque[slot]);
    }
}
