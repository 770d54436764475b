//! Bodies solved by the adaptive [`DormandPrince`] pair: the reference for coupled schemes.

use super::dormand_prince::{DormandPrince, FlatLaw, Settings};
use super::phase::{Law, Phase, Rates};
use super::rk4::quaternion_rate;
use crate::Error;
use crate::math::{Quat, Vec3};

/// Bodies on their way: x, q, p, L as one system of numbers, with q̇ = ½ (0, ω) q and the quaternions put back
/// to unit length between steps.
#[derive(Clone, Debug)]
pub struct PhaseSolver {
    flat: DormandPrince,
    phase: Phase,
    stage: Phase,
    rates: Rates,
}

/// Numbers a body: x, rot, p, l.
const PER_BODY: usize = 13;

impl PhaseSolver {
    /// The bodies in state `phase` at time t \[s\].
    ///
    /// # Errors
    /// If a tolerance or a number of the state is not acceptable.
    pub fn new(settings: Settings, t: f64, phase: &Phase) -> Result<Self, Error> {
        let mut y = vec![0.0; PER_BODY * phase.n_bodies()];
        write_flat(phase, &mut y);
        let mut flat = DormandPrince::new(settings, t, y)?;
        flat.projection = Some(normalize_quaternions);
        Ok(Self { flat, phase: phase.clone(), stage: phase.clone(), rates: Rates::zero(phase.n_bodies()) })
    }
    /// The time reached \[s\].
    pub fn t(&self) -> f64 {
        self.flat.t()
    }
    /// The state at [`PhaseSolver::t`].
    pub fn phase(&self) -> &Phase {
        &self.phase
    }
    /// The steps accepted so far, and those rejected.
    pub fn n_steps(&self) -> (usize, usize) {
        self.flat.n_steps()
    }
    /// Goes on to exactly `t_end` \[s\], forwards or backwards.
    ///
    /// # Errors
    /// As [`DormandPrince::advance`].
    pub fn advance(&mut self, law: &mut Law<'_>, t_end: f64) -> Result<(), Error> {
        self.go(law, |flat, flat_law| flat.advance(flat_law, t_end))
    }
    /// Takes one accepted step towards `t_end` \[s\], not beyond it.
    ///
    /// # Errors
    /// As [`DormandPrince::step`].
    pub fn step(&mut self, law: &mut Law<'_>, t_end: f64) -> Result<(), Error> {
        self.go(law, |flat, flat_law| flat.step(flat_law, t_end))
    }
    /// The state at a time of the last step \[s\], to fourth order.
    pub fn interpolate(&self, t: f64) -> Phase {
        let mut y = vec![0.0; self.flat.y().len()];
        self.flat.interpolate(t, &mut y);
        let mut phase = self.phase.clone();
        read_flat(&y, &mut phase);
        phase
    }

    fn go(
        &mut self,
        law: &mut Law<'_>,
        run: impl FnOnce(&mut DormandPrince, &mut FlatLaw<'_>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let Self { flat, phase, stage, rates } = self;
        let outcome = run(flat, &mut |t, y, dy| {
            read_flat(y, stage);
            law(t, stage, rates);
            write_rates(y, rates, dy);
        });
        read_flat(flat.y(), phase);
        outcome
    }
}

fn normalize_quaternions(y: &mut [f64]) {
    for body in y.chunks_exact_mut(PER_BODY) {
        let q = read_quat(body).normalized();
        body[3..7].copy_from_slice(&<[f64; 4]>::from(q));
    }
}

fn read_quat(body: &[f64]) -> Quat {
    Quat::new(body[3], body[4], body[5], body[6])
}

fn write_flat(phase: &Phase, y: &mut [f64]) {
    for (body, out) in y.chunks_exact_mut(PER_BODY).enumerate() {
        out[0..3].copy_from_slice(&phase.x[body].to_array());
        out[3..7].copy_from_slice(&<[f64; 4]>::from(phase.rot[body]));
        out[7..10].copy_from_slice(&phase.p[body].to_array());
        out[10..13].copy_from_slice(&phase.l[body].to_array());
    }
}

fn read_flat(y: &[f64], phase: &mut Phase) {
    for (body, part) in y.chunks_exact(PER_BODY).enumerate() {
        phase.x[body] = Vec3::new(part[0], part[1], part[2]);
        phase.rot[body] = read_quat(part).normalized();
        phase.p[body] = Vec3::new(part[7], part[8], part[9]);
        phase.l[body] = Vec3::new(part[10], part[11], part[12]);
    }
}

fn write_rates(y: &[f64], rates: &Rates, dy: &mut [f64]) {
    for (body, (part, out)) in y.chunks_exact(PER_BODY).zip(dy.chunks_exact_mut(PER_BODY)).enumerate() {
        out[0..3].copy_from_slice(&rates.v[body].to_array());
        out[3..7].copy_from_slice(&<[f64; 4]>::from(quaternion_rate(rates.w[body], read_quat(part))));
        out[7..10].copy_from_slice(&rates.force[body].to_array());
        out[10..13].copy_from_slice(&rates.torque[body].to_array());
    }
}
