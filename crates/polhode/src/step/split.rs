//! Stage 7: the bodies move.
//!
//! A symmetric step is `kick h/2 · drift h · kick h/2`. A pinned body's drift is the free motion that its pins leave, and its
//! kicks end with the impulses µ that bring its pinned points to rest. Uniform gravity is the same before and after a drift, so where nothing else pushes, the three go
//! through the cache together.

use super::Moving;
use super::closing::MOST_EVALUATIONS;
use super::forces::forces;

use super::scratch::Scratch;
use crate::field::Field;
use crate::integrate::lanes;
use crate::integrate::{Composition, Drift, Kick, Phase, exponential};
use crate::math::{Quat, Vec3};
use crate::model::Model;
use crate::par::{Executor, Split};
use crate::solve::pins::{Pinned, Point, Residual};
use crate::state::{Inputs, State};

/// Bodies a block: 24 KiB of state, which stays in the first-level cache between kick, drift and kick.
const BLOCK: usize = 128;

/// The slices of a block of moving bodies.
struct Block<'a> {
    x: &'a mut [Vec3],
    rot: &'a mut [Quat],
    p: &'a mut [Vec3],
    l: &'a mut [Vec3],
}

impl<'a> Block<'a> {
    fn of(bodies: &'a mut Phase, range: core::ops::Range<usize>) -> Self {
        Self {
            x: &mut bodies.x[range.clone()],
            rot: &mut bodies.rot[range.clone()],
            p: &mut bodies.p[range.clone()],
            l: &mut bodies.l[range],
        }
    }
}

impl Split for Block<'_> {
    fn len(&self) -> usize {
        self.x.len()
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        let (xa, xb) = self.x.split_at_mut(at);
        let (ra, rb) = self.rot.split_at_mut(at);
        let (pa, pb) = self.p.split_at_mut(at);
        let (la, lb) = self.l.split_at_mut(at);
        (Self { x: xa, rot: ra, p: pa, l: la }, Self { x: xb, rot: rb, p: pb, l: lb })
    }
}

/// What pushes the bodies during a kick.
struct Push<'a> {
    model: &'a Model,
    /// `None` where uniform gravity is all there is.
    wrenches: Option<(&'a [Vec3], &'a [Vec3])>,
}

impl<'a> Push<'a> {
    fn new(model: &'a Model, scratch: &'a Scratch) -> Self {
        let wrenches = (!scratch.only_gravity).then_some((scratch.force.as_slice(), scratch.torque.as_slice()));
        Self { model, wrenches }
    }

    /// p += h F, L += h τ for the bodies from slot `first` on.
    fn kick(&self, first: usize, p: &mut [Vec3], l: &mut [Vec3], h: f64) {
        match self.wrenches {
            None => {
                let gravity = self.model.gravity;
                if gravity == Vec3::ZERO {
                    return;
                }
                let range = first..first + p.len();
                let (mass, scale) = (&self.model.mass[range.clone()], &self.model.gravity_scale[range]);
                for ((p, &m), &s) in p.iter_mut().zip(mass).zip(scale) {
                    *p += gravity * (h * (m * s));
                }
            }
            Some((force, torque)) => {
                for (i, (p, l)) in p.iter_mut().zip(l).enumerate() {
                    *p += force[first + i] * h;
                    *l += torque[first + i] * h;
                }
            }
        }
    }
}

/// x += h p/m and the free rotation, for the bodies from slot `first` on.
fn drift(model: &Model, drift: Drift, first: usize, block: &mut Block, h: f64) {
    let range = first..first + block.len();
    for ((x, &p), &inv_mass) in block.x.iter_mut().zip(block.p.iter()).zip(&model.inv_mass[range.clone()]) {
        *x += p * (h * inv_mass);
    }
    let k = &model.inv_inertia[range];
    match drift {
        Drift::Pdmv(order) => lanes::rotate(model.lanes, order, block.rot, block.l, k, h),
        other => {
            for ((rot, &l), &k) in block.rot.iter_mut().zip(block.l.iter()).zip(k) {
                *rot = other.rotate(*rot, l, k, h);
            }
        }
    }
}

/// A split step: the composition's stages, one after the other.
pub(super) fn advance(moving: Moving, drift: Drift, kick: Kick, composition: Composition, dt: f64) -> Residual {
    let Moving { model, inputs, state, scratch, executor } = moving;
    let longest =
        composition.fractions().iter().fold(0.0f64, |longest, fraction| longest.max(fraction.abs())) * dt.abs();
    let mut stage = Stage { model, inputs, state, scratch, executor, drift, longest };
    let time = stage.state.now();
    stage.state.pin_impulse.fill(Vec3::ZERO);
    stage.forces(time);
    match kick {
        Kick::Explicit => {
            stage.drift(dt);
            stage.kick(dt);
            Residual::default()
        }
        Kick::Symplectic => {
            stage.kick(dt);
            stage.drift(dt);
            Residual::default()
        }
        Kick::Verlet => {
            let mut worst = Residual::default();
            let mut elapsed = 0.0;
            for &fraction in composition.fractions() {
                let h = fraction * dt;
                elapsed += h;
                worst = worst.max(stage.verlet(h, time + elapsed));
            }
            worst
        }
    }
}

/// One stage of a split step.
struct Stage<'a> {
    model: &'a Model,
    inputs: &'a Inputs,
    state: &'a mut State,
    scratch: &'a mut Scratch,
    executor: &'a Executor,
    drift: Drift,
    /// The longest stage of the composition \[s\].
    longest: f64,
}

impl Stage<'_> {
    fn forces(&mut self, time: f64) {
        forces(self.model, self.inputs, &self.state.bodies, time, self.executor, self.scratch);
    }

    fn kick(&mut self, h: f64) {
        let push = Push::new(self.model, self.scratch);
        let block = Block::of(&mut self.state.bodies, 0..self.model.n_dynamic());
        self.executor.for_each(block, BLOCK, &|first, block: Block| push.kick(first, block.p, block.l, h));
    }

    fn drift(&mut self, h: f64) {
        let model = self.model;
        let block = Block::of(&mut self.state.bodies, 0..model.n_dynamic());
        self.executor.for_each(block, BLOCK, &|first, mut block: Block| drift(model, self.drift, first, &mut block, h));
        self.prescribed(h);
    }

    /// Kinematic bodies move at the velocities that p and l hold for them.
    fn prescribed(&mut self, h: f64) {
        let bodies = &mut self.state.bodies;
        for i in self.model.n_dynamic()..self.model.n_moving() {
            bodies.x[i] += bodies.p[i] * h;
            bodies.rot[i] = exponential::rotate(bodies.rot[i], bodies.l[i], Vec3::splat(1.0), h);
        }
    }

    /// Kick h/2, drift h, kick h/2, ending at `time`; pinned bodies turn about their pins.
    fn verlet(&mut self, h: f64, time: f64) -> Residual {
        let model = self.model;
        let fused = self.scratch.only_gravity;
        self.keep_pinned();
        let push = Push::new(model, self.scratch);
        let block = Block::of(&mut self.state.bodies, 0..model.n_dynamic());
        self.executor.for_each(block, BLOCK, &|first, mut block: Block| {
            push.kick(first, block.p, block.l, 0.5 * h);
            drift(model, self.drift, first, &mut block, h);
            if fused {
                push.kick(first, block.p, block.l, 0.5 * h);
            }
        });
        self.prescribed(h);
        let residual = self.drift_pinned(h);
        if fused {
            self.close_pins(h, true);
        } else if model.fields.iter().any(Field::depends_on_velocity) {
            self.close_implicitly(h, time);
        } else {
            self.forces(time);
            self.kick(0.5 * h);
            self.close_pins(h, true);
        }
        residual
    }

    /// The closing half kick by forces that depend on where it leads: see [`super::closing`].
    fn close_implicitly(&mut self, h: f64, time: f64) {
        let n = self.model.n_dynamic();
        self.scratch.closing.open(&self.state.bodies, n);
        for evaluation in 1..=MOST_EVALUATIONS {
            self.forces(time);
            self.scratch.closing.reopen(&mut self.state.bodies, n);
            self.kick(0.5 * h);
            self.close_pins(h, false);
            let last = evaluation == MOST_EVALUATIONS;
            let unsolved = self.scratch.closing.improve(&mut self.state.bodies, n, evaluation == 1, last);
            if last {
                self.scratch.unconverged = self.scratch.unconverged.max(unsolved);
            }
            if unsolved == 0 {
                break;
            }
        }
        for (sum, closing) in self.state.pin_impulse.iter_mut().zip(&self.state.pin_closing) {
            *sum += *closing;
        }
    }

    /// Remembers the pinned bodies as they are before the blocks drift them freely.
    fn keep_pinned(&mut self) {
        let bodies = &self.state.bodies;
        self.scratch.pinned.clear();
        for group in self.model.pins.chunk_by(|a, b| a.body == b.body) {
            // Pins go with their body, so the slot is there.
            let Some(i) = self.model.slots.slot(group[0].body) else { continue };
            self.scratch.pinned.push((i, bodies.x[i], bodies.rot[i], bodies.p[i], bodies.l[i]));
        }
    }

    /// The opening half kick of the pinned bodies and their drift.
    fn drift_pinned(&mut self, h: f64) -> Residual {
        let mut worst = Residual::default();
        let mut first = 0;
        for which in 0..self.scratch.pinned.len() {
            let (slot, x, rot, mut p, mut l) = self.scratch.pinned[which];
            let (p1, l1) = (core::slice::from_mut(&mut p), core::slice::from_mut(&mut l));
            Push::new(self.model, self.scratch).kick(slot, p1, l1, 0.5 * h);
            let bodies = &mut self.state.bodies;
            (bodies.x[slot], bodies.rot[slot], bodies.p[slot], bodies.l[slot]) = (x, rot, p, l);
            let pins = self.pins_at(first);
            first = pins.end;
            let map = self.drift;
            let mut body = pinned(self.model, &mut self.state.bodies, slot);
            let sum = &mut self.state.pin_impulse[pins.clone()];
            let rows = &mut self.scratch.rows;
            if let [pin] = self.model.pins[pins.clone()] {
                let rotate = |rot, l, k| map.rotate(rot, l, k, h);
                sum[0] += body.drift_about(&pin, self.model.mass[slot], rotate, rows);
                continue;
            }
            let k = self.model.inv_inertia[slot];
            let closing = &mut self.state.pin_closing[pins.clone()];
            let points = |i: usize| point(self.model, pins.start + i);
            let rotate = |rot, l, h| map.rotate(rot, l, k, h);
            let [k1, k2, k3] = self.model.pins[pins.start].inv_inertia.to_array();
            let least_inertia = 1.0 / k1.max(k2).max(k3);
            worst =
                worst.max(body.drift_by_rattle(points, (closing, sum), (h, self.longest, least_inertia), rotate, rows));
        }
        worst
    }

    /// The closing half of the pinned bodies: kick (where the blocks' was lost with their free drift), µ.
    fn close_pins(&mut self, h: f64, count: bool) {
        let mut first = 0;
        for which in 0..self.scratch.pinned.len() {
            let slot = self.scratch.pinned[which].0;
            if self.scratch.only_gravity {
                let bodies = &mut self.state.bodies;
                let (p, l) = (core::slice::from_mut(&mut bodies.p[slot]), core::slice::from_mut(&mut bodies.l[slot]));
                Push::new(self.model, self.scratch).kick(slot, p, l, 0.5 * h);
            }
            let pins = self.pins_at(first);
            let start = first;
            first = pins.end;
            let mut body = pinned(self.model, &mut self.state.bodies, slot);
            let closing = &mut self.state.pin_closing[pins.clone()];
            body.close_velocities(|i| point(self.model, start + i), closing, &mut self.scratch.rows);
            if count {
                for (sum, closing) in self.state.pin_impulse[pins].iter_mut().zip(closing.iter()) {
                    *sum += *closing;
                }
            }
        }
    }

    /// The run of pins of one body that starts at `first`.
    fn pins_at(&self, first: usize) -> core::ops::Range<usize> {
        let body = self.model.pins[first].body;
        let count = self.model.pins[first..].iter().take_while(|p| p.body == body).count();
        first..first + count
    }
}

pub(super) fn point(model: &Model, pin: usize) -> Point {
    Point { point: model.pins[pin].point, at: model.pins[pin].at }
}

/// The pinned body in a slot.
pub(super) fn pinned<'a>(model: &Model, bodies: &'a mut Phase, slot: usize) -> Pinned<'a> {
    Pinned {
        x: &mut bodies.x[slot],
        rot: &mut bodies.rot[slot],
        p: &mut bodies.p[slot],
        l: &mut bodies.l[slot],
        inv_mass: model.inv_mass[slot],
        inv_inertia: model.inv_inertia[slot],
    }
}
