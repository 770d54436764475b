//! Everything else that a step computes.

use super::closing::Closing;
use super::forces::PointMasses;
use crate::field::Field;
use crate::integrate::phase::Work;
use crate::math::{Quat, Vec3};
use crate::model::Model;
use crate::solve::pins::Rows;

/// What a step writes before it reads. A test fills it with NaN between steps and finds the same bits.
#[derive(Clone, Debug, Default)]
pub struct Scratch {
    /// Whether uniform gravity is all that pushes, and the next two arrays are not written. Stage `forces`.
    pub(super) only_gravity: bool,
    /// Sum of forces, world \[N\] (n_bodies). Stage `forces`.
    pub(super) force: Vec<Vec3>,
    /// Sum of torques about the centres of mass, world [N·m] (n_bodies). Stage `forces`.
    pub(super) torque: Vec<Vec3>,
    /// Point masses of the dynamic bodies. Stage `forces`, for mutual gravitation.
    pub(super) points: PointMasses,
    /// Whether a wrench on the body was not finite in this step (n_bodies). Stage `forces`.
    pub(super) refused: Vec<bool>,
    /// Slot, x, rot, p, l of the pinned bodies at the start of the substep. Stage `substep`.
    pub(super) pinned: Vec<(usize, Vec3, Quat, Vec3, Vec3)>,
    /// Rows of the pins of one body. Stage `substep`.
    pub(super) rows: Rows,
    /// The iteration of the closing half, only for fields that ask for the velocity. Stage `substep`.
    pub(super) closing: Closing,
    /// Bodies whose velocity-dependent forces were not solved for. Stage `substep`.
    pub(super) unconverged: usize,
    /// Stages of the coupled schemes. Stage `substep`.
    pub(super) work: Work,
}

impl Scratch {
    /// Makes room for a model, so that nothing after it allocates, and forgets what the last step reported.
    pub(super) fn begin(&mut self, model: &Model) {
        let n = model.slots.len();
        for array in [&mut self.force, &mut self.torque] {
            array.resize(n, Vec3::splat(f64::NAN));
        }
        self.refused.clear();
        self.refused.resize(n, false);
        self.unconverged = 0;
        if model.fields.iter().any(Field::depends_on_velocity) {
            self.closing.fit(n);
        }
        let most = model.pins.chunk_by(|a, b| a.body == b.body).map(<[_]>::len).max().unwrap_or(0);
        self.rows.reserve(most);
    }

    /// Overwrites everything with what no computation survives. For tests.
    pub fn poison(&mut self) {
        self.only_gravity = !self.only_gravity;
        for array in [&mut self.force, &mut self.torque] {
            array.fill(Vec3::splat(f64::NAN));
        }
        self.points.points.clear();
        self.points.points.push((f64::NAN, Vec3::splat(f64::NAN)));
        self.points.first.clear();
        self.refused.fill(true);
        self.unconverged = usize::MAX;
        self.pinned.clear();
        self.closing.poison();
        self.rows.poison();
        self.work.poison();
    }
}
