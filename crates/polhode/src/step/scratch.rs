//! Everything else that a step computes.

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
    /// Point masses \[kg\] and where they are, world \[m\], body after body. Stage `forces`, for mutual gravitation.
    pub(super) points: Vec<(f64, Vec3)>,
    /// First point mass of each dynamic body, and the end (n_dynamic + 1). Stage `forces`.
    pub(super) first_point: Vec<usize>,
    /// Slots whose wrench was not finite in this step. Stage `forces`.
    pub(super) quarantined: Vec<usize>,
    /// Slot, x, rot, p, l of the pinned bodies at the start of the substep. Stage `substep`.
    pub(super) pinned: Vec<(usize, Vec3, Quat, Vec3, Vec3)>,
    /// Rows of the pins of one body. Stage `substep`.
    pub(super) rows: Rows,
    /// Momenta at the opening of the closing half (n_dynamic); only for fields that ask for the velocity. Stage `substep`.
    pub(super) p_half: Vec<Vec3>,
    /// The same for the angular momentum (n_dynamic).
    pub(super) l_half: Vec<Vec3>,
    /// Whether an adaptive method gave up within this step. Stage `substep`.
    pub(super) stalled: bool,
    /// Stages of the coupled schemes. Stage `substep`.
    pub(super) work: Work,
}

impl Scratch {
    /// Makes room for a model, so that nothing after it allocates, and forgets the last step's reports.
    pub(super) fn begin(&mut self, model: &Model) {
        self.quarantined.clear();
        self.stalled = false;
        let n = model.slots.len();
        for array in [&mut self.force, &mut self.torque, &mut self.p_half, &mut self.l_half] {
            array.resize(n, Vec3::splat(f64::NAN));
        }
        let most = model.pins.chunk_by(|a, b| a.body == b.body).map(<[_]>::len).max().unwrap_or(0);
        self.rows.reserve(most);
    }

    /// Overwrites everything with what no computation survives. For tests.
    pub fn poison(&mut self) {
        self.only_gravity = !self.only_gravity;
        for array in [&mut self.force, &mut self.torque, &mut self.p_half, &mut self.l_half] {
            array.fill(Vec3::splat(f64::NAN));
        }
        self.points.clear();
        self.points.push((f64::NAN, Vec3::splat(f64::NAN)));
        self.first_point.clear();
        self.quarantined.clear();
        self.stalled = false;
        self.pinned.clear();
        self.rows.poison();
        self.work.poison();
    }
}
