//! Stage 1: gravity, what the user applies, and the fields, summed into one wrench a body.

use super::scratch::Scratch;
use crate::field::{Law, MutualGravity, Wrench};
use crate::integrate::Phase;
use crate::math::Vec3;
use crate::model::Model;
use crate::par::{Executor, Split};
use crate::state::{Inputs, view};
use crate::store::BodyId;

/// Bodies a block: some 10 µs of work for a few laws.
const BLOCK: usize = 256;

/// The slices that a block of bodies writes.
struct Block<'a> {
    force: &'a mut [Vec3],
    torque: &'a mut [Vec3],
}

impl Split for Block<'_> {
    fn len(&self) -> usize {
        self.force.len()
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        let (fa, fb) = self.force.split_at_mut(at);
        let (ta, tb) = self.torque.split_at_mut(at);
        (Self { force: fa, torque: ta }, Self { force: fb, torque: tb })
    }
}

/// Writes force and torque of every dynamic body at the given motion.
///
/// Without fields and user forces it only notes that uniform gravity is all there is, and nobody reads the arrays.
pub(super) fn forces(
    model: &Model,
    inputs: &Inputs,
    bodies: &Phase,
    time: f64,
    executor: &Executor,
    scratch: &mut Scratch,
) {
    let n = model.n_dynamic();
    scratch.only_gravity = model.fields.is_empty() && !inputs.any;
    if scratch.only_gravity {
        return;
    }
    if model.fields.iter().any(|f| matches!(f.law, Law::MutualGravity(_))) {
        place_point_masses(model, bodies, scratch);
    }
    let (points, first_point) = (&scratch.points, &scratch.first_point);
    let block = Block { force: &mut scratch.force[..n], torque: &mut scratch.torque[..n] };
    executor.for_each(block, BLOCK, &|first, block: Block| {
        for (i, (force, torque)) in block.force.iter_mut().zip(block.torque).enumerate() {
            let slot = first + i;
            let mut sum =
                Wrench { force: model.gravity * (model.mass[slot] * model.gravity_scale[slot]), torque: Vec3::ZERO };
            sum += Wrench { force: inputs.force[slot], torque: inputs.torque[slot] };
            let body = view(model, bodies, time, slot);
            for field in &model.fields {
                if !field.applies_to(body.id) {
                    continue;
                }
                sum += match &field.law {
                    Law::Central(f) => f.wrench(&body),
                    Law::LinearDrag(f) => f.wrench(&body),
                    Law::QuadraticDrag(f) => f.wrench(&body),
                    Law::Buoyancy(f) => f.wrench(&body),
                    Law::Custom(f) => f.wrench(&body),
                    Law::MutualGravity(f) => gravitation(f, points, first_point, slot, body.x),
                    Law::Spring(_) | Law::TorsionSpring(_) => Wrench::ZERO,
                };
            }
            (*force, *torque) = (sum.force, sum.torque);
        }
    });
    springs(model, bodies, time, scratch);
    quarantine(n, scratch);
}

/// Laws between two bodies, in the order in which they were added; what acts on the world or on a body that forces do not
/// move is dropped.
fn springs(model: &Model, bodies: &Phase, time: f64, scratch: &mut Scratch) {
    let n = model.n_dynamic();
    let slot_of = |id: Option<BodyId>| id.and_then(|id| model.slots.slot(id));
    for field in &model.fields {
        let (a, b, on) = match &field.law {
            Law::Spring(s) => {
                let (a, b) = (slot_of(s.a.body), slot_of(s.b.body));
                let views = [a, b].map(|slot| slot.map(|slot| view(model, bodies, time, slot)));
                (a, b, s.wrenches(views[0].as_ref(), views[1].as_ref()))
            }
            Law::TorsionSpring(s) => {
                let (a, Some(b)) = (slot_of(s.a), slot_of(Some(s.b))) else { continue };
                let view_a = a.map(|slot| view(model, bodies, time, slot));
                (a, Some(b), s.wrenches(view_a.as_ref(), &view(model, bodies, time, b)))
            }
            _ => continue,
        };
        for (slot, wrench) in [(a, on.0), (b, on.1)] {
            if let Some(slot) = slot.filter(|&slot| slot < n) {
                scratch.force[slot] += wrench.force;
                scratch.torque[slot] += wrench.torque;
            }
        }
    }
}

/// Lists the point masses of all dynamic bodies: one a shape, or the whole body where it has none.
fn place_point_masses(model: &Model, bodies: &Phase, scratch: &mut Scratch) {
    scratch.points.clear();
    scratch.first_point.clear();
    for slot in 0..model.n_dynamic() {
        scratch.first_point.push(scratch.points.len());
        point_masses(model, bodies, slot, &mut |mass, x| scratch.points.push((mass, x)));
    }
    scratch.first_point.push(scratch.points.len());
}

/// The point masses of one body, world.
pub(super) fn point_masses(model: &Model, bodies: &Phase, slot: usize, visit: &mut impl FnMut(f64, Vec3)) {
    let parts = &model.point_masses[slot];
    if parts.is_empty() {
        return visit(model.mass[slot], bodies.x[slot]);
    }
    for &(mass, point) in parts {
        visit(mass, bodies.x[slot] + bodies.rot[slot].rotate(point));
    }
}

/// The pull of all other bodies' point masses on one body's.
fn gravitation(f: &MutualGravity, points: &[(f64, Vec3)], first: &[usize], slot: usize, x: Vec3) -> Wrench {
    let mut sum = Wrench::ZERO;
    let own = first[slot]..first[slot + 1];
    for &(m, a) in &points[own.clone()] {
        let mut force = Vec3::ZERO;
        for &(m_b, b) in points[..own.start].iter().chain(&points[own.end..]) {
            force += f.pull(m, a, m_b, b);
        }
        sum += Wrench::at(force, a - x);
    }
    sum
}

/// A force that is no number would take its body, and then every body that it touches, out of the world: it is dropped,
/// and the body is reported.
fn quarantine(n: usize, scratch: &mut Scratch) {
    for slot in 0..n {
        if !(scratch.force[slot].is_finite() && scratch.torque[slot].is_finite()) {
            scratch.force[slot] = Vec3::ZERO;
            scratch.torque[slot] = Vec3::ZERO;
            if !scratch.quarantined.contains(&slot) {
                scratch.quarantined.push(slot);
            }
        }
    }
}
